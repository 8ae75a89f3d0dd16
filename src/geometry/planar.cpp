// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/contact.h"

// Points lie in one plane exactly if their differences from the first have rank 2 at most, that
// is if all 3 x 3 minors of the matrix of these differences vanish.

namespace seam::geometry {
namespace {

using symbolic::all;
using symbolic::atom;

std::vector<std::vector<int>> triples(int n) {
  std::vector<std::vector<int>> result;
  for (int a = 0; a < n; ++a)
    for (int b = a + 1; b < n; ++b)
      for (int c = b + 1; c < n; ++c) result.push_back({a, b, c});
  return result;
}

}  // namespace

Proposition planar(const std::vector<Point>& points) {
  std::vector<Proposition> parts;
  if (points.size() < 4) return all({});
  std::vector<Point> differences;
  for (std::size_t i = 1; i < points.size(); ++i) differences.push_back(points[i] - points[0]);
  for (const auto& chosen : triples(static_cast<int>(differences.size())))
    for (const auto& rows : triples(static_cast<int>(points[0].size()))) {
      std::vector<Point> columns;
      for (const int k : chosen)
        columns.push_back(
            {differences[k][rows[0]], differences[k][rows[1]], differences[k][rows[2]]});
      parts.push_back(atom(symbolic::Zero{determinant(columns)}, "in one plane"));
    }
  return all(std::move(parts));
}

}  // namespace seam::geometry
