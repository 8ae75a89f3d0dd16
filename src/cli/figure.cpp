// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/figure.h"

#include <array>
#include <cmath>

namespace seam::cli {
namespace {

using geometry::Patch;
using Triple = std::array<double, 3>;
using Net = std::vector<std::vector<Triple>>;

constexpr int cuts = 8;  // a side of a patch

Triple mixed(const Triple& a, double s, const Triple& b, double t, const Triple& c = {},
             double r = 0) {
  Triple result;
  for (int i = 0; i < 3; ++i) result[i] = s * a[i] + t * b[i] + r * c[i];
  return result;
}

Triple minus(const Triple& a, const Triple& b) {
  return mixed(a, 1, b, -1);
}
Triple cross(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Triple& a, const Triple& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// de Casteljau on rounded control points.
Triple point(const Patch& patch, Net net, double u, double v) {
  if (patch.shape() == Patch::Shape::triangle) {
    for (std::size_t n = net.size() - 1; n > 0; --n)
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i + j < n; ++i)
          net[j][i] = mixed(net[j][i], 1 - u - v, net[j][i + 1], u, net[j + 1][i], v);
    return net[0][0];
  }
  for (auto& row : net)
    for (std::size_t n = row.size() - 1; n > 0; --n)
      for (std::size_t i = 0; i < n; ++i) row[i] = mixed(row[i], 1 - u, row[i + 1], u);
  for (std::size_t n = net.size() - 1; n > 0; --n)
    for (std::size_t j = 0; j < n; ++j) net[j][0] = mixed(net[j][0], 1 - v, net[j + 1][0], v);
  return net[0][0];
}

// Gauss curvature from central differences: a colour, no value.
double curvature(const Patch& patch, const Net& net, double u, double v) {
  constexpr double h = 1e-3;
  const auto at = [&](double x, double y) { return point(patch, net, u + x * h, v + y * h); };
  const Triple p = at(0, 0), pu = mixed(at(1, 0), 0.5 / h, at(-1, 0), -0.5 / h),
               pv = mixed(at(0, 1), 0.5 / h, at(0, -1), -0.5 / h);
  const auto second = [&](const Triple& a, const Triple& b) {
    return mixed(mixed(a, 1, b, 1), 1 / (h * h), p, -2 / (h * h));
  };
  const Triple puu = second(at(1, 0), at(-1, 0)), pvv = second(at(0, 1), at(0, -1));
  const Triple puv = mixed(mixed(at(1, 1), 1, at(-1, -1), 1), 0.25 / (h * h),
                           mixed(at(1, -1), 1, at(-1, 1), 1), -0.25 / (h * h));
  const Triple n = cross(pu, pv);
  const double size = dot(n, n);
  if (size < 1e-12) return 0;
  return (dot(n, puu) * dot(n, pvv) - dot(n, puv) * dot(n, puv)) / (size * size);
}

void add_patch(report::FigureRun& figure, const Patch& patch, const symbolic::Numbers& numbers,
               bool coloured) {
  Net net;
  for (const auto& row : patch.rows()) {
    net.emplace_back();
    for (const auto& control : row)
      net.back().push_back({numbers.approximate(control[0]), numbers.approximate(control[1]),
                            numbers.approximate(control[2])});
  }
  const auto add = [&](double u0, double v0, double u1, double v1, double u2, double v2) {
    std::array<Triple, 3> corners = {point(patch, net, u0, v0), point(patch, net, u1, v1),
                                     point(patch, net, u2, v2)};
    Triple normal = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]));
    if (dot(normal, corners[0]) < 0) {
      std::swap(corners[1], corners[2]);
      normal = mixed(normal, -1, normal, 0);
    }
    const double length = std::sqrt(dot(normal, normal));
    const int first = static_cast<int>(figure.points.size());
    for (const Triple& corner : corners) {
      figure.points.push_back(corner);
      figure.normals.push_back(mixed(normal, length > 0 ? 1 / length : 0, normal, 0));
      if (coloured)
        figure.values.push_back(curvature(patch, net, (u0 + u1 + u2) / 3, (v0 + v1 + v2) / 3));
    }
    figure.triangles.push_back({first, first + 1, first + 2});
  };
  const bool triangle = patch.shape() == Patch::Shape::triangle;
  const double step = 1.0 / cuts;
  for (int j = 0; j < cuts; ++j)
    for (int i = 0; i < (triangle ? cuts - j : cuts); ++i) {
      const double u = i * step, v = j * step;
      add(u, v, u + step, v, u, v + step);
      if (!triangle || i + j < cuts - 1) add(u + step, v, u + step, v + step, u, v + step);
    }
}

}  // namespace

report::FigureRun sampled(const claims::MeantFigure& figure, const symbolic::Numbers& numbers) {
  report::FigureRun result;
  result.title = figure.title;
  if (figure.coloured_by == "gauss") result.coloured_by = "gauss";
  const bool coloured = !result.coloured_by.empty();
  const auto usable = [](const Patch& patch) {
    if (patch.dimension() != 3) return false;
    for (const auto& row : patch.rows())
      for (const auto& control : row)
        for (const auto& entry : control)
          if (!symbolic::is_number(entry)) return false;
    return true;
  };
  if (const auto* patch = figure.value->as<Patch>(); patch && usable(*patch))
    add_patch(result, *patch, numbers, coloured);
  if (const auto* surface = figure.value->as<geometry::Surface>())
    for (const Patch& patch : surface->patches) add_patch(result, patch, numbers, coloured);
  return result;
}

}  // namespace seam::cli
