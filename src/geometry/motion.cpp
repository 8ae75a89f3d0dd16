// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/motion.h"

#include "exact/contract.h"

namespace seam::geometry {

Point reflect(const Point& x, const Point& n, const Formula& d, const Formula& share) {
  const Formula steps = 2 * (dot(n, x) - d) * share;
  return x - steps * n;
}

// Rodrigues, with the axis k not normalised: x -> c x + s (k x x)/|k| + (1 - c) (k.x) k/(k.k).
Matrix rotation(const Point& axis, const Formula& cosine, const Formula& sine,
                Numbers& numbers) {
  exact::require(axis.size() == 3, "rotation: dimension 3 only");
  const Formula share = numbers.inverse(norm2(axis));
  const Formula across = sine * share * numbers.sqrt(norm2(axis)),
                lengthwise = (1 - cosine) * share;
  Matrix columns;  // the images of the unit vectors
  for (const Point& x : identity(3).rows)
    columns.rows.push_back(cosine * x + across * cross(axis, x) +
                           (lengthwise * dot(axis, x)) * axis);
  return transpose(columns);
}

}  // namespace seam::geometry
