// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "symbolic/formula.h"

// Points and vectors are lists of coordinates. Operands of one operation have one dimension.
namespace seam::geometry {

using symbolic::Formula;
using symbolic::Point;

Point operator+(const Point&, const Point&);
Point operator-(const Point&, const Point&);
Point operator*(const Formula&, const Point&);

Formula dot(const Point&, const Point&);
Formula norm2(const Point&);              ///< the square of the length
Point cross(const Point&, const Point&);  ///< dimension 3

/// Of a square matrix, by its columns.
Formula determinant(const std::vector<Point>& columns);

}  // namespace seam::geometry
