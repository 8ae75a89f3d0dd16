// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/contract.h"
#include "geometry/patch.h"

// The derivative of sum B_i^n(u) P_i is n sum B_i^(n-1)(u) (P_(i+1) - P_i). On the triangle,
// with w = 1 - u - v, the one in the direction u is n sum B_ijk^(n-1) (P_(i+1,j) - P_(i,j)),
// likewise in v. (Farin, Curves and Surfaces for CAGD, 5.3 and 17.4.) A constant has the
// derivative 0.

namespace seam::geometry {
namespace {

Patch zero_like(const Patch& p) {
  return map(p, [](const Point& x) { return Point(x.size()); });
}

Patch in_u(const Patch& p) {
  const int degree = p.degree_u();
  if (degree == 0) return zero_like(p);
  std::vector<std::vector<Point>> rows;
  for (const auto& row : p.rows()) {
    if (row.size() == 1) break;  // the tip of a triangle
    rows.emplace_back();
    for (std::size_t i = 0; i + 1 < row.size(); ++i)
      rows.back().push_back(degree * (row[i + 1] - row[i]));
  }
  return {p.shape(), std::move(rows)};
}

Patch in_v(const Patch& p) {
  const int degree = p.degree_v();
  if (degree == 0) return zero_like(p);
  std::vector<std::vector<Point>> rows;
  for (int j = 0; j < degree; ++j) {
    rows.emplace_back();
    for (std::size_t i = 0; i < p.rows()[j + 1].size(); ++i)
      rows.back().push_back(degree * (p.rows()[j + 1][i] - p.rows()[j][i]));
  }
  return {p.shape(), std::move(rows)};
}

}  // namespace

Patch derivative(const Patch& p, int i, int j) {
  exact::require(i >= 0 && j >= 0, "derivative: negative order");
  Patch result = p;
  for (; i > 0; --i) result = in_u(result);
  for (; j > 0; --j) result = in_v(result);
  return result;
}

Curve derivative(const Curve& curve, int order) {
  exact::require(order >= 0, "derivative: negative order");
  return {derivative(Patch::square({curve.control}), order, 0).rows()[0]};
}

Point derivative(const Patch& p, int i, int j, const Formula& u, const Formula& v) {
  return evaluate(derivative(p, i, j), u, v);
}

Point derivative(const Curve& curve, int order, const Formula& u) {
  return evaluate(derivative(curve, order), u);
}

Point normal(const Patch& p, const Formula& u, const Formula& v) {
  return cross(derivative(p, 1, 0, u, v), derivative(p, 0, 1, u, v));
}

}  // namespace seam::geometry
