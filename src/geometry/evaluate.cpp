// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/patch.h"

namespace seam::geometry {
namespace {

using symbolic::product;

Formula choose(int n, int k) {
  exact::Integer binomial;
  mpz_bin_uiui(binomial.get_mpz_t(), static_cast<unsigned long>(n),
               static_cast<unsigned long>(k));
  return Formula(exact::Rational(binomial));
}

// The Bernstein polynomials of degree n at u, with w = 1 - u.
std::vector<Formula> basis(int n, const Formula& u, const Formula& w) {
  std::vector<Formula> result;
  for (int i = 0; i <= n; ++i)
    result.push_back(product({choose(n, i), power(u, i), power(w, n - i)}));
  return result;
}

// sum weights[k] * points[k]
Point combine(const std::vector<Formula>& weights, const std::vector<Point>& points) {
  Point result;
  for (std::size_t coordinate = 0; coordinate < points[0].size(); ++coordinate) {
    std::vector<Formula> terms;
    for (std::size_t k = 0; k < points.size(); ++k)
      terms.push_back(weights[k] * points[k][coordinate]);
    result.push_back(sum(std::move(terms)));
  }
  return result;
}

}  // namespace

Point evaluate(const Curve& curve, const Formula& u) {
  return combine(basis(curve.degree(), u, 1 - u), curve.control);
}

Point evaluate(const Patch& p, const Formula& u, const Formula& v) {
  const int m = p.degree_u(), n = p.degree_v();
  std::vector<Formula> weights;
  std::vector<Point> points;
  if (p.shape() == Patch::Shape::triangle) {
    const Formula w = 1 - u - v;
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i + j <= n; ++i) {
        weights.push_back(product(
            {choose(n, j), choose(n - j, i), power(u, i), power(v, j), power(w, n - i - j)}));
        points.push_back(p.control(i, j));
      }
  } else {
    const auto in_u = basis(m, u, 1 - u), in_v = basis(n, v, 1 - v);
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= m; ++i) {
        weights.push_back(in_u[i] * in_v[j]);
        points.push_back(p.control(i, j));
      }
  }
  return combine(weights, points);
}

}  // namespace seam::geometry
