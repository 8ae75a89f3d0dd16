// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/shape_moments.h"

#include "geometry/matrix.h"

// With C = sum x x^T, which a rotation M turns into M C M^T, trace and determinant of C and of
// its square stay; so do lengths |x|, and the length of sum |x|^2 x.

namespace seam::geometry {

std::vector<Moment> moments(const std::vector<Point>& points) {
  Formula second, fourth, sixth;
  Point third(3);
  Matrix spread{{Point(3), Point(3), Point(3)}};
  for (const Point& x : points) {
    const Formula r2 = norm2(x);
    second += r2;
    fourth += r2 * r2;
    sixth += r2 * r2 * r2;
    third = third + r2 * x;
    for (int i = 0; i < 3; ++i) spread.rows[i] = spread.rows[i] + x[i] * x;
  }
  Formula trace_of_square;
  for (const Point& row : spread.rows) trace_of_square += norm2(row);
  return {{"sum of squared distances", second, 2},
          {"sum of fourth powers of distances", fourth, 4},
          {"sum of sixth powers of distances", sixth, 6},
          {"trace of the squared matrix of inertia", trace_of_square, 4},
          {"determinant of the matrix of inertia", determinant(spread.rows), 6},
          {"squared length of the third moment", norm2(third), 6}};
}

}  // namespace seam::geometry
