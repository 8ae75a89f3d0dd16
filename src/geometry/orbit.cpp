// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "geometry/nearness.h"
#include "geometry/surface.h"

namespace seam::geometry {
namespace {

bool same_net(const Patch& p, const Patch& q, const Numbers& numbers) {
  return p.shape() == q.shape() && p.degree_u() == q.degree_u() &&
         p.degree_v() == q.degree_v() &&
         std::ranges::equal(p.rows(), q.rows(), [&](const auto& a, const auto& b) {
           return std::ranges::equal(
               a, b, [&](const Point& x, const Point& y) { return equal(x, y, numbers); });
         });
}

// The sum of the control points: no symmetry of the domain changes it.
Approximation middle(const Patch& p, const Numbers& numbers) {
  Approximation result(p.dimension());
  for (const auto& row : p.rows())
    for (const Point& point : row) {
      const Approximation x = approximate(point, numbers);
      for (std::size_t k = 0; k < x.size(); ++k) result[k] += x[k];
    }
  return result;
}

}  // namespace

std::optional<Patch> parametrised_like(const Patch& p, const Patch& q, const Numbers& numbers) {
  if (p.shape() != q.shape()) return std::nullopt;
  for (int side = 1; side <= q.sides(); ++side)
    for (const bool reversed : {false, true})
      if (Patch other = along(q, side, reversed); same_net(p, other, numbers)) return other;
  return std::nullopt;
}

Surface orbit(const Patch& patch, const std::vector<Matrix>& group, const Numbers& numbers) {
  std::vector<Patch> images{patch};
  std::vector<Approximation> middles{middle(patch, numbers)};
  for (const Matrix& m : group) {
    Patch image = map(patch, [&](const Point& x) { return normal_form(m * x, numbers); });
    Approximation here = middle(image, numbers);
    bool known = false;
    for (std::size_t k = 0; k < images.size() && !known; ++k)
      known =
          near(here, middles[k]) && parametrised_like(image, images[k], numbers).has_value();
    if (known) continue;
    images.push_back(std::move(image));
    middles.push_back(std::move(here));
  }
  return surface(std::move(images), numbers);
}

}  // namespace seam::geometry
