// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/frame.h"

#include <iterator>

// With n = a x b and d = n.n > 0 the vectors b x n / d, n x a / d, n / d are dual to a, b, n:
// a.(b x n) = n.n, b.(n x a) = n.n, and the other products vanish. So
//
//   M = x (b x n)^T/d + y (n x a)^T/d ± (x x y) n^T/d
//
// carries a, b, n to x, y, ±(x x y). The products among a, b, n are those among the images
// exactly if they are so for x and y (n is orthogonal to both, and n.n = (a.a)(b.b) - (a.b)^2),
// and a linear map that keeps the products of a basis is orthogonal. Its determinant is then
// ±1, with the sign chosen.

namespace seam::geometry {

std::optional<Frame> Frame::of(const std::vector<Point>& points, Numbers& numbers) {
  for (std::size_t j = 1; j < points.size(); ++j)
    for (std::size_t i = 0; i < j; ++i)
      if (!is_zero(norm2(cross(points[i], points[j])), numbers))
        return Frame(points[i], points[j], numbers);
  return std::nullopt;
}

Frame::Frame(Point a, Point b, Numbers& numbers) : a_(std::move(a)), b_(std::move(b)) {
  const Point n = cross(a_, b_);
  const Formula share = normal_form(numbers.inverse(norm2(n)), numbers);
  for (const Point& direction : {cross(b_, n), cross(n, a_), n})
    dual_.push_back(normal_form(share * direction, numbers));
}

Matrix Frame::carry(const Point& x, const Point& y, bool mirrored,
                    const Numbers& numbers) const {
  const Point z = (mirrored ? -1 : 1) * cross(x, y);
  Matrix result;
  for (int row = 0; row < 3; ++row)
    result.rows.push_back(
        normal_form(x[row] * dual_[0] + y[row] * dual_[1] + z[row] * dual_[2], numbers));
  return result;
}

bool Frame::fits(const Point& x, const Point& y, const Numbers& numbers) const {
  return equal(norm2(x), norm2(a_), numbers) && equal(norm2(y), norm2(b_), numbers) &&
         equal(dot(x, y), dot(a_, b_), numbers);
}

std::vector<std::pair<int, int>> Frame::images(const std::vector<Point>& points,
                                               const Numbers& numbers) const {
  const auto from_a = approximate(a_, numbers), from_b = approximate(b_, numbers);
  const auto to = approximate(points, numbers);
  const auto like = [](const Approximation& x, const Approximation& y, double product) {
    return near(dot(x, y), product, dot(x, x) + dot(y, y));
  };
  std::vector<std::pair<int, int>> result;
  for (int i = 0; i < std::ssize(to); ++i) {
    if (!like(to[i], to[i], dot(from_a, from_a))) continue;
    for (int j = 0; j < std::ssize(to); ++j)
      if (like(to[j], to[j], dot(from_b, from_b)) && like(to[i], to[j], dot(from_a, from_b)) &&
          fits(points[i], points[j], numbers))
        result.emplace_back(i, j);
  }
  return result;
}

}  // namespace seam::geometry
