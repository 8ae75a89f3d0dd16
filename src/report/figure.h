// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/run.h"

namespace seam::report {

/// A picture of the facets as a tikzpicture, seen from a fixed direction, far facets first;
/// with a scale where it is coloured. It proves nothing. Numbers are rounded to a few digits,
/// so that equal facets give equal bytes.
std::string picture(const FigureRun&);

}  // namespace seam::report
