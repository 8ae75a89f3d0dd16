// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/patch.h"
#include "symbolic/numbers.h"

// Patches to try things on.
namespace seam::geometry::testing {

Formula ratio(long numerator, long denominator);
inline const Formula u = Formula::symbol("u"), v = Formula::symbol("v");

/// The patch of a polynomial map in u and v, of these degrees.
Patch square_of(const Point& map, int m, int n, const symbolic::Numbers&);
Patch triangle_of(const Point& map, int n, const symbolic::Numbers&);

Patch flat_square(const Point& at_00, const Point& at_10, const Point& at_11,
                  const Point& at_01);
Patch flat_triangle(const Point& at_00, const Point& at_10, const Point& at_01);

/// Every choice of parameters: 6 or 8 patches, the same surface.
std::vector<Patch> parametrisations(const Patch&);

}  // namespace seam::geometry::testing
