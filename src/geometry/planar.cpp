// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/contact.h"

// Points lie in one plane exactly if their differences d from the first have rank 2 at most,
// that is if every determinant of three of them, in any three coordinates, vanishes. By Cauchy
// and Binet the sum of the squares of these determinants, for three coordinates, is the
// determinant of the 3 x 3 matrix sum d d^T; it vanishes, being a sum of squares, only if all
// of them do.

namespace seam::geometry {
namespace {

using symbolic::all;
using symbolic::atom;

Formula sum_of_squared_determinants(const std::vector<Point>& vectors) {
  std::vector<Point> gram(3, Point(3));
  for (const Point& d : vectors)
    for (int row = 0; row < 3; ++row) gram[row] = gram[row] + d[row] * d;
  return determinant(gram);
}

}  // namespace

Proposition planar(const std::vector<Point>& points) {
  std::vector<Proposition> parts;
  const std::size_t dimension = points.empty() ? 0 : points[0].size();
  for (std::size_t a = 0; a < dimension; ++a)
    for (std::size_t b = 0; b < a; ++b)
      for (std::size_t c = 0; c < b; ++c) {
        std::vector<Point> differences;
        differences.reserve(points.size());
        for (const Point& x : points)
          differences.push_back(Point{x[a], x[b], x[c]} -
                                Point{points[0][a], points[0][b], points[0][c]});
        parts.push_back(
            atom(symbolic::Zero{sum_of_squared_determinants(differences)}, "in one plane"));
      }
  return all(std::move(parts));
}

}  // namespace seam::geometry
