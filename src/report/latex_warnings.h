// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/run.h"

namespace seam::report {

/// What may be a slip, or nothing where there is none.
std::string latex_warnings(const FileRun&);

}  // namespace seam::report
