// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include "check/region.h"

namespace seam::check {

/// A number for each of some variables.
using Point = std::map<int, Polynomial>;

Point read_point(Context&, const certificate::Point&);

/// The formula's value there. Throws `Open` if it holds a variable that has none.
Polynomial value_at(Context&, Polynomial formula, const Point&);

/// Throws `Open` unless the point is certainly one of the region, and the functions have there
/// the values that it gives them.
void demand_inside(Context&, const Region&, const std::set<int>& functions, const Point&);

}  // namespace seam::check
