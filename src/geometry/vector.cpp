// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/vector.h"

#include <algorithm>
#include <iterator>

#include "exact/contract.h"

namespace seam::geometry {
namespace {

using exact::require;

void require_one_dimension(const Point& a, const Point& b) {
  require(a.size() == b.size(), "vectors of different dimensions");
}

}  // namespace

Point operator+(const Point& a, const Point& b) {
  require_one_dimension(a, b);
  Point result;
  std::ranges::transform(a, b, std::back_inserter(result),
                         [](const Formula& x, const Formula& y) { return x + y; });
  return result;
}

Point operator-(const Point& a, const Point& b) {
  require_one_dimension(a, b);
  Point result;
  std::ranges::transform(a, b, std::back_inserter(result),
                         [](const Formula& x, const Formula& y) { return x - y; });
  return result;
}

Point operator*(const Formula& factor, const Point& a) {
  Point result;
  for (const Formula& x : a) result.push_back(factor * x);
  return result;
}

Formula dot(const Point& a, const Point& b) {
  require_one_dimension(a, b);
  std::vector<Formula> terms;
  std::ranges::transform(a, b, std::back_inserter(terms),
                         [](const Formula& x, const Formula& y) { return x * y; });
  return sum(std::move(terms));
}

Formula norm2(const Point& a) {
  return dot(a, a);
}

Point cross(const Point& a, const Point& b) {
  require(a.size() == 3 && b.size() == 3, "cross: dimension 3 only");
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Formula determinant(const std::vector<Point>& columns) {
  for (const Point& column : columns)
    require(column.size() == columns.size(), "determinant: the matrix is not square");
  if (columns.empty()) return 1;
  if (columns.size() == 3) return dot(columns[0], cross(columns[1], columns[2]));

  Formula result;  // by the first column
  for (std::size_t row = 0; row < columns.size(); ++row) {
    std::vector<Point> minor(columns.begin() + 1, columns.end());
    for (Point& column : minor) column.erase(column.begin() + static_cast<std::ptrdiff_t>(row));
    const Formula term = columns[0][row] * determinant(minor);
    result = row % 2 == 0 ? result + term : result - term;
  }
  return result;
}

}  // namespace seam::geometry
