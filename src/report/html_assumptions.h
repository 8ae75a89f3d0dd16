// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/run.h"

namespace seam::report {

/// What the verdicts rest on: the parameters with what they range over, the conditions under
/// which the formulas mean something, the claims that other claims rest on; nothing if there is
/// nothing.
std::string html_assumptions(const FileRun&);

}  // namespace seam::report
