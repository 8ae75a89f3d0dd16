// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/run.h"

namespace seam::report {

/// The results as one JSON document with a final newline, as docs/command-line.md says. Equal
/// runs give equal bytes: no times.
std::string json(const Run&);

}  // namespace seam::report
