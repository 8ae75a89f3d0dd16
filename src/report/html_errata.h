// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/run.h"

namespace seam::report {

/// What is printed and was refuted, by places in the paper, beside what should stand there
/// where that is known; nothing if there is none.
std::string html_errata(const FileRun&);

}  // namespace seam::report
