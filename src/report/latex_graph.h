// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/run.h"

namespace seam::report {

/// The claims that rest on others, and those others, as a drawing: what a claim rests on stands
/// to the left of it. Empty where there are none, or too many to be legible.
std::string latex_graph(const FileRun&);

}  // namespace seam::report
