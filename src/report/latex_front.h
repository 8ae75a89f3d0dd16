// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/run.h"

namespace seam::report {

/// The title, the verdicts counted by section, and what read which file with which libraries.
std::string latex_front(const FileRun&, const Run&);

}  // namespace seam::report
