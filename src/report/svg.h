// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/run.h"

namespace seam::report {

/// The drawing of a figure as a picture of its own, with title, description and legend.
std::string svg(const FigureRun&);

}  // namespace seam::report
