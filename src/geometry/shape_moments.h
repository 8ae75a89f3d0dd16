// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "geometry/vector.h"

namespace seam::geometry {

/// A number that belongs to a set of points about the origin, and does not change when they are
/// rotated, mirrored or renamed. When they are scaled by k it is multiplied by k^degree.
struct Moment {
  std::string name;
  Formula value;
  int degree;
};

/// The first is the sum of the squares of the distances from the origin. Dimension 3.
std::vector<Moment> moments(const std::vector<Point>&);

}  // namespace seam::geometry
