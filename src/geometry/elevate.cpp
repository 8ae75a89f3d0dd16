// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/contract.h"
#include "geometry/patch.h"

// On multiplying by (1 - u) + u, or by w + u + v, the entry with exponents e of degree n + 1
// becomes the mean of its neighbours of degree n, each lower by one in one exponent, with
// weights e / (n + 1). (Farin, Curves and Surfaces for CAGD, 6.1 and 17.6.)

namespace seam::geometry {
namespace {

using Shape = Patch::Shape;
using Row = std::vector<Point>;

Formula ratio(int a, int b) {
  exact::Rational value(a, b);
  value.canonicalize();
  return Formula(value);
}

Row raise(const Row& row) {
  const int n = static_cast<int>(row.size()) - 1;
  Row result{row.front()};
  for (int i = 1; i <= n; ++i)
    result.push_back(ratio(i, n + 1) * row[i - 1] + ratio(n + 1 - i, n + 1) * row[i]);
  result.push_back(row.back());
  return result;
}

Patch raise_u(const Patch& p) {
  std::vector<Row> rows;
  for (const Row& row : p.rows()) rows.push_back(raise(row));
  return Patch::square(std::move(rows));
}

Patch raise_v(const Patch& p) {
  return swap(raise_u(swap(p)));
}

Patch raise_triangle(const Patch& p) {
  const int n = p.degree_u();
  std::vector<Row> rows(n + 2);
  for (int j = 0; j <= n + 1; ++j)
    for (int i = 0; i + j <= n + 1; ++i) {
      const int k = n + 1 - i - j;
      Point mean(p.dimension());
      if (i > 0) mean = mean + ratio(i, n + 1) * p.control(i - 1, j);
      if (j > 0) mean = mean + ratio(j, n + 1) * p.control(i, j - 1);
      if (k > 0) mean = mean + ratio(k, n + 1) * p.control(i, j);
      rows[j].push_back(std::move(mean));
    }
  return Patch::triangle(std::move(rows));
}

}  // namespace

Patch elevate(const Patch& p) {
  return p.shape() == Shape::triangle ? raise_triangle(p) : raise_v(raise_u(p));
}

Curve elevate(const Curve& curve) {
  return {raise(curve.control)};
}

Patch elevate(const Patch& p, int degree) {
  exact::require(p.degree_u() <= degree && p.degree_v() <= degree, "elevate: degree too low");
  Patch result = p;
  if (p.shape() == Shape::triangle) {
    while (result.degree_u() < degree) result = raise_triangle(result);
  } else {
    while (result.degree_u() < degree) result = raise_u(result);
    while (result.degree_v() < degree) result = raise_v(result);
  }
  return result;
}

Curve elevate(const Curve& curve, int degree) {
  exact::require(curve.degree() <= degree, "elevate: degree too low");
  Curve result = curve;
  while (result.degree() < degree) result = elevate(result);
  return result;
}

}  // namespace seam::geometry
