// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/chart.h"

namespace seam::geometry {
namespace {

const Formula& u() {
  static const Formula symbol = Formula::symbol(parameter_u);
  return symbol;
}
const Formula& v() {
  static const Formula symbol = Formula::symbol(parameter_v);
  return symbol;
}

Point derived(Point point, const std::string& parameter, int order) {
  for (; order > 0; --order)
    for (Formula& coordinate : point) coordinate = symbolic::diff(coordinate, parameter);
  return point;
}

}  // namespace

Chart chart(const Patch& p) {
  return {[p](int i, int j) { return derivative(p, i, j, u(), v()); },
          domain(p, parameter_u, parameter_v)};
}
Chart chart(const Point& point, symbolic::Domain domain) {
  return {
      [point](int i, int j) { return derived(derived(point, parameter_u, i), parameter_v, j); },
      std::move(domain)};
}

Arc arc(const Curve& x) {
  return {[x](int order) { return derivative(x, order, u()); }, true};
}
Arc arc(const Point& point, bool is_segment) {
  return {[point](int order) { return derived(point, parameter_u, order); }, is_segment};
}

Point normal(const Chart& y) {
  return cross(y.derivative(1, 0), y.derivative(0, 1));
}

Quotient gauss(const Chart& y) {
  return gauss(normal(y), y.derivative(2, 0), y.derivative(1, 1), y.derivative(0, 2));
}

}  // namespace seam::geometry
