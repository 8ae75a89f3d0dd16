// SPDX-License-Identifier: GPL-3.0-or-later
#include "nets.h"

#include "symbolic/coefficients.h"

// u^i v^j is the sum of the Bernstein polynomials with k >= i, l >= j, each times
// C(k,i) C(l,j) / (C(m,i) C(n,j)) on the square, C(k,i) C(l,j) / (n! / (i! j! (n-i-j)!)) on the
// triangle.

namespace seam::geometry::testing {
namespace {

using symbolic::Numbers;

long choose(long n, long k) {
  long result = 1;
  for (long i = 0; i < k; ++i) result = result * (n - i) / (i + 1);
  return result;
}

using Coordinate = std::map<std::vector<int>, Formula>;

std::vector<Coordinate> coordinates(const Point& map, const Numbers& numbers) {
  std::vector<Coordinate> result;
  for (const Formula& x : map) result.push_back(coefficients(x, {"u", "v"}, numbers));
  return result;
}

template <class Total>
Point control(const std::vector<Coordinate>& map, int k, int l, Total total) {
  Point point;
  for (const Coordinate& coordinate : map) {
    Formula x;
    for (const auto& [e, coefficient] : coordinate)
      if (e[0] <= k && e[1] <= l)
        x += ratio(choose(k, e[0]) * choose(l, e[1]), total(e[0], e[1])) * coefficient;
    point.push_back(x);
  }
  return point;
}

}  // namespace

Formula ratio(long numerator, long denominator) {
  exact::Rational value(numerator, denominator);
  value.canonicalize();
  return Formula(value);
}

Patch square_of(const Point& map, int m, int n, const Numbers& numbers) {
  const auto total = [&](int i, int j) { return choose(m, i) * choose(n, j); };
  const auto monomials = coordinates(map, numbers);
  std::vector<std::vector<Point>> rows(n + 1);
  for (int l = 0; l <= n; ++l)
    for (int k = 0; k <= m; ++k) rows[l].push_back(control(monomials, k, l, total));
  return Patch::square(rows);
}

Patch triangle_of(const Point& map, int n, const Numbers& numbers) {
  const auto total = [&](int i, int j) { return choose(n, i) * choose(n - i, j); };
  const auto monomials = coordinates(map, numbers);
  std::vector<std::vector<Point>> rows(n + 1);
  for (int l = 0; l <= n; ++l)
    for (int k = 0; k + l <= n; ++k) rows[l].push_back(control(monomials, k, l, total));
  return Patch::triangle(rows);
}

Patch flat_square(const Point& at_00, const Point& at_10, const Point& at_11,
                  const Point& at_01) {
  return Patch::square({{at_00, at_10}, {at_01, at_11}});
}

Patch flat_triangle(const Point& at_00, const Point& at_10, const Point& at_01) {
  return Patch::triangle({{at_00, at_10}, {at_01}});
}

std::vector<Patch> parametrisations(const Patch& p) {
  std::vector<Patch> result;
  for (int side = 1; side <= p.sides(); ++side)
    for (const bool reversed : {false, true}) result.push_back(along(p, side, reversed));
  return result;
}

}  // namespace seam::geometry::testing
