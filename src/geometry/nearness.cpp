// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/nearness.h"

#include <algorithm>
#include <cmath>
#include <iterator>

// A double here is off by 2^-40 and a rounding at most, and what is computed from a few of them
// by little more, relative to the sizes that enter. `near` allows for 1e-7: it never parts
// equal points, and what it lets through is tested exactly.

namespace seam::geometry {
namespace {

double approximate(const Formula& x, const Numbers& numbers) {
  const auto [low, high] = numbers.enclosure(x, exact::Rational(1, 1L << 40));
  return low.get_d();
}

}  // namespace

Approximation approximate(const Point& point, const Numbers& numbers) {
  Approximation result;
  for (const Formula& x : point) result.push_back(approximate(x, numbers));
  return result;
}

std::vector<Approximation> approximate(const std::vector<Point>& points,
                                       const Numbers& numbers) {
  std::vector<Approximation> result;
  result.reserve(points.size());
  for (const Point& point : points) result.push_back(approximate(point, numbers));
  return result;
}

bool near(double a, double b, double size) {
  constexpr double tolerance = 1e-7;
  return !(std::abs(a - b) > tolerance * (1 + size));
}

bool near(double a, double b) {
  return near(a, b, std::abs(a) + std::abs(b));
}

bool near(const Approximation& a, const Approximation& b) {
  return std::ranges::equal(a, b, [](double x, double y) { return near(x, y); });
}

double dot(const Approximation& a, const Approximation& b) {
  double result = 0;
  for (std::size_t i = 0; i < a.size(); ++i) result += a[i] * b[i];
  return result;
}

Approximation operator-(const Approximation& a, const Approximation& b) {
  Approximation result = a;
  for (std::size_t i = 0; i < a.size(); ++i) result[i] -= b[i];
  return result;
}

std::vector<Point> distinct(const std::vector<Point>& points, const Numbers& numbers) {
  std::vector<Point> result;
  std::vector<Approximation> seen;
  for (const Point& point : points) {
    Approximation here = approximate(point, numbers);
    bool known = false;
    for (std::size_t i = 0; i < seen.size() && !known; ++i)
      known = near(seen[i], here) && equal(result[i], point, numbers);
    if (known) continue;
    result.push_back(normal_form(point, numbers));
    seen.push_back(std::move(here));
  }
  return result;
}

PointIndex::PointIndex(const std::vector<Point>& points, const Numbers& numbers)
    : points_(points), approximations_(approximate(points, numbers)), numbers_(numbers) {}

std::optional<int> PointIndex::find(const Point& point) const {
  const Approximation here = approximate(point, numbers_);
  for (std::size_t i = 0; i < points_.size(); ++i)
    if (near(approximations_[i], here) && equal(points_[i], point, numbers_))
      return static_cast<int>(i);
  return std::nullopt;
}

}  // namespace seam::geometry
