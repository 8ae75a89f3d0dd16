// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/run.h"

namespace seam::report {

/// What was refuted, by place in the paper: what is printed, what should stand there, and why;
/// first where that is known, then the rest. Empty where nothing was refuted.
std::string latex_errata(const FileRun&);

}  // namespace seam::report
