// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/rounded_patch.h"

// A derivative of a patch in Bernstein form has differences of control points for control
// points, times the degree. A net that ran empty is that of the function 0.

namespace seam::draw {
namespace {

using Net = RoundedPatch::Net;
using Shape = RoundedPatch::Shape;

Net along_rows(Shape shape, const Net& net) {
  Net result;
  for (const auto& row : net) {
    if (row.size() < 2) continue;
    const double degree =
        static_cast<double>(shape == Shape::triangle ? net.size() - 1 : row.size() - 1);
    result.emplace_back();
    for (std::size_t i = 0; i + 1 < row.size(); ++i)
      result.back().push_back(degree * (row[i + 1] - row[i]));
  }
  return result;
}

Net across_rows(const Net& net) {
  Net result;
  const auto degree = static_cast<double>(net.size()) - 1;
  for (std::size_t j = 0; j + 1 < net.size(); ++j) {
    result.emplace_back();
    for (std::size_t i = 0; i < net[j + 1].size(); ++i)
      result.back().push_back(degree * (net[j + 1][i] - net[j][i]));
  }
  return result;
}

// De Casteljau.
Vector value(Shape shape, Net net, double u, double v) {
  if (net.empty()) return {};
  if (shape == Shape::triangle) {
    for (std::size_t n = net.size() - 1; n > 0; --n)
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i + j < n; ++i)
          net[j][i] = (1 - u - v) * net[j][i] + u * net[j][i + 1] + v * net[j + 1][i];
    return net[0][0];
  }
  for (auto& row : net)
    for (std::size_t n = row.size() - 1; n > 0; --n)
      for (std::size_t i = 0; i < n; ++i) row[i] = (1 - u) * row[i] + u * row[i + 1];
  for (std::size_t n = net.size() - 1; n > 0; --n)
    for (std::size_t j = 0; j < n; ++j) net[j][0] = (1 - v) * net[j][0] + v * net[j + 1][0];
  return net[0][0];
}

// What is left of rounding where terms cancel is taken for 0, so that flat is flat.
constexpr double rounding = 1e-12;

double difference(double a, double b) {
  return std::abs(a - b) > rounding * (std::abs(a) + std::abs(b)) ? a - b : 0;
}

double inner(const Vector& a, const Vector& b) {
  const double result = dot(a, b);
  return std::abs(result) > rounding * length(a) * length(b) ? result : 0;
}

}  // namespace

double Jet::gauss() const {
  const Vector n = normal();
  const double size = dot(n, n);
  const double a = inner(n, uu), b = inner(n, uv), c = inner(n, vv);
  return difference(a * c, b * b) / (size * size);
}

double Jet::mean() const {
  const Vector n = normal();
  const double size = dot(n, n);
  const double straight = dot(v, v) * inner(n, uu) + dot(u, u) * inner(n, vv);
  return difference(straight, 2 * dot(u, v) * inner(n, uv)) / (2 * size * std::sqrt(size));
}

RoundedPatch::RoundedPatch(const geometry::Patch& patch, const symbolic::Numbers& numbers)
    : shape_(patch.shape()) {
  for (const auto& row : patch.rows()) {
    net_.emplace_back();
    for (const auto& control : row) {
      Vector rounded{};
      for (std::size_t i = 0; i < control.size() && i < 3; ++i)
        rounded[i] = numbers.approximate(control[i]);
      net_.back().push_back(rounded);
    }
  }
  u_ = along_rows(shape_, net_);
  v_ = across_rows(net_);
  uu_ = along_rows(shape_, u_);
  uv_ = across_rows(u_);
  vv_ = across_rows(v_);
}

Vector RoundedPatch::point(double u, double v) const {
  return value(shape_, net_, u, v);
}

Jet RoundedPatch::jet(double u, double v) const {
  return {value(shape_, net_, u, v), value(shape_, u_, u, v),  value(shape_, v_, u, v),
          value(shape_, uu_, u, v),  value(shape_, uv_, u, v), value(shape_, vv_, u, v)};
}

}  // namespace seam::draw
