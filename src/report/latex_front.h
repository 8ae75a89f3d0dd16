// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/run.h"

namespace seam::report {

/// The title, the verdicts counted by section, and what file was read.
std::string latex_front(const FileRun&, const std::string& tool);

/// What the paper prints and what was refuted, with the corrections; empty where there is
/// nothing.
std::string latex_errata(const FileRun&);

}  // namespace seam::report
