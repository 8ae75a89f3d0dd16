// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/vector.h"

namespace seam::geometry {

/// Rectangular, by its rows.
struct Matrix {
  std::vector<Point> rows;
};

Point operator*(const Matrix&, const Point&);
Matrix operator*(const Matrix&, const Matrix&);
Matrix transpose(const Matrix&);
Matrix identity(int n);

}  // namespace seam::geometry
