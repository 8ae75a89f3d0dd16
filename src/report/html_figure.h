// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/run.h"

namespace seam::report {

/// A drawing, and the samples it is made of for the script that turns it.
std::string html_figure(const FigureRun&);

}  // namespace seam::report
