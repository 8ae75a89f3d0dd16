// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/matrix.h"
#include "symbolic/numbers.h"

namespace seam::geometry {

using symbolic::Numbers;

/// Mirror image in the plane { x : n.x = d }, where `share` is 1/(n.n).
Point reflect(const Point&, const Point& n, const Formula& d, const Formula& share);

/// Rotation about an axis (of numbers, not 0: NumberError) by the angle with this cosine and
/// sine, counterclockwise seen against the axis. Orthogonal if cosine^2 + sine^2 = 1.
Matrix rotation(const Point& axis, const Formula& cosine, const Formula& sine, Numbers&);

}  // namespace seam::geometry
