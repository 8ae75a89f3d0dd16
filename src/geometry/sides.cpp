// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>

#include "exact/contract.h"
#include "geometry/patch.h"

namespace seam::geometry {
namespace {

using Shape = Patch::Shape;

void require_side(Shape shape, int k) {
  exact::require(k >= 1 && k <= (shape == Shape::triangle ? 3 : 4), "no such side");
}

// The entry with weight i on the corner `to`, j on the third, the rest on `from`.
Patch triangle_along(const Patch& p, Ends side) {
  const int n = p.degree_u(), third = 3 - side.from - side.to;
  std::vector<std::vector<Point>> rows(n + 1);
  for (int j = 0; j <= n; ++j)
    for (int i = 0; i + j <= n; ++i) {
      std::array<int, 3> exponent{};
      exponent[side.from] = n - i - j;
      exponent[side.to] = i;
      exponent[third] = j;
      rows[j].push_back(p.control(exponent[1], exponent[2]));
    }
  return Patch::triangle(std::move(rows));
}

Patch square_along(const Patch& p, int k, bool reversed) {
  const int m = p.degree_u(), n = p.degree_v();
  const bool turned = k == 2 || k == 4;  // the side runs with v
  const int length = turned ? n : m, depth = turned ? m : n;
  std::vector<std::vector<Point>> rows(depth + 1);
  for (int j = 0; j <= depth; ++j)
    for (int i = 0; i <= length; ++i) {
      const int along = reversed ? length - i : i;
      const int across = k >= 3 ? depth - j : j;
      rows[j].push_back(turned ? p.control(across, along) : p.control(along, across));
    }
  return Patch::square(std::move(rows));
}

}  // namespace

Ends ends(Shape shape, int k) {
  require_side(shape, k);
  static constexpr std::array<Ends, 3> triangle{{{0, 1}, {0, 2}, {1, 2}}};
  static constexpr std::array<Ends, 4> square{{{0, 1}, {0, 3}, {3, 2}, {1, 2}}};
  return shape == Shape::triangle ? triangle[k - 1] : square[k - 1];
}

const Point& corner(const Patch& p, int number) {
  exact::require(number >= 0 && number < p.sides(), "no such corner");
  const int m = p.degree_u(), n = p.degree_v();
  switch (number) {
    case 0:
      return p.control(0, 0);
    case 1:
      return p.control(m, 0);
    case 2:
      return p.shape() == Shape::triangle ? p.control(0, n) : p.control(m, n);
    default:
      return p.control(0, n);
  }
}

Patch along(const Patch& p, int k, bool reversed) {
  require_side(p.shape(), k);
  if (p.shape() == Shape::square) return square_along(p, k, reversed);
  const auto [from, to] = ends(p.shape(), k);
  return triangle_along(p, reversed ? Ends{to, from} : Ends{from, to});
}

Curve edge(const Patch& p, int k) {
  return {along(p, k, false).rows()[0]};
}

// NOLINTNEXTLINE(bugprone-exception-escape): not the swap of two values
Patch swap(const Patch& p) {
  return along(p, 2, false);
}

}  // namespace seam::geometry
