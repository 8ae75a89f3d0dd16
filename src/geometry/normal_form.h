// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/vector.h"
#include "symbolic/numbers.h"

// Exact work on numbers and on points whose coordinates are numbers.
namespace seam::geometry {

using symbolic::Numbers;

/// Decided exactly, and at once where both are one formula.
bool equal(const Formula& a, const Formula& b, const Numbers&);
bool equal(const Point& a, const Point& b, const Numbers&);
bool is_zero(const Formula&, const Numbers&);

/// The same number as a short formula, which still rests on all facts that the longer one rests
/// on. What holds variables stays as it is.
Formula normal_form(const Formula&, const Numbers&);
Point normal_form(const Point&, const Numbers&);

}  // namespace seam::geometry
