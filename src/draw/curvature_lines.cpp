// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include "draw/figure_parts.h"

// A line of curvature has at each point a principal direction, an eigenvector of the shape
// operator: (E M - F L) du^2 + (E N - G L) du dv + (F N - G M) dv^2 = 0. It is followed with
// steps of one length in space, by the midpoint rule, until it leaves the domain or meets an
// umbilic, where every direction is principal.

namespace seam::draw {
namespace {

using Line = report::FigureRun::Line;
using Place = std::array<double, 2>;

constexpr int lines_a_side = 4;

// Of length 1 in space, on the side of `before` if that is given.
std::optional<Place> principal(const Sheet& sheet, const Place& at, bool first,
                               const std::optional<Place>& before) {
  const Jet jet = sheet.jet(at[0], at[1]);
  const Vector n = report::direction(jet.normal());
  const double E = dot(jet.u, jet.u), F = dot(jet.u, jet.v), G = dot(jet.v, jet.v);
  const double L = dot(n, jet.uu), M = dot(n, jet.uv), N = dot(n, jet.vv);
  const double a = E * M - F * L, b = E * N - G * L, c = F * N - G * M;
  const double root = std::sqrt(std::max(0.0, b * b - 4 * a * c));
  const double size = E * std::abs(N) + G * std::abs(L) + (E + G) * std::abs(M);
  if (!(root > 1e-3 * size)) return std::nullopt;
  // The two solutions, each in the form that does not cancel.
  Place d = first == (b >= 0) ? Place{-(b + (b >= 0 ? root : -root)), 2 * a}
                              : Place{-2 * c, b + (b >= 0 ? root : -root)};
  const double length = std::sqrt(E * d[0] * d[0] + 2 * F * d[0] * d[1] + G * d[1] * d[1]);
  if (!(length > 0)) return std::nullopt;
  for (double& x : d) x /= length;
  if (before) {
    const auto& [p, q] = *before;
    const double inner = E * d[0] * p + F * (d[0] * q + d[1] * p) + G * d[1] * q;
    if (inner < 0) d = {-d[0], -d[1]};
  }
  return d;
}

bool is_inside(const Sheet& sheet, const Place& at) {
  const bool square = at[0] >= 0 && at[1] >= 0 && at[0] <= 1 && at[1] <= 1;
  return square && (sheet.shape == RoundedPatch::Shape::square || at[0] + at[1] <= 1);
}

void follow(const Sheet& sheet, Place at, bool first, double sign, double step,
            std::vector<Vector>& points) {
  constexpr int most_steps = 200;
  std::optional<Place> before;
  for (int k = 0; k < most_steps; ++k) {
    const auto here = principal(sheet, at, first, before);
    if (!here) return;
    const double s = before ? step : sign * step;
    const Place middle = {at[0] + s / 2 * (*here)[0], at[1] + s / 2 * (*here)[1]};
    const auto there = principal(sheet, middle, first, here);
    if (!there) return;
    at = {at[0] + s * (*there)[0], at[1] + s * (*there)[1]};
    if (!is_inside(sheet, at)) return;
    before = Place{s / step * (*there)[0], s / step * (*there)[1]};
    points.push_back(sheet.jet(at[0], at[1]).point);
  }
}

}  // namespace

void add_curvature_lines(report::FigureRun& figure, const Sheet& sheet) {
  const Vector middle = sheet.jet(0.3, 0.3).point;
  double size = 0;
  for (const auto& [u, v] : {Place{0, 0}, Place{1, 0}, Place{0, 1}})
    size = std::max(size, length(sheet.jet(u, v).point - middle));
  for (int j = 0; j < lines_a_side; ++j)
    for (int i = 0; i < lines_a_side; ++i) {
      const Place at = {(i + 0.5) / lines_a_side, (j + 0.5) / lines_a_side};
      if (!is_inside(sheet, at)) continue;
      for (const bool first : {true, false}) {
        Line line{Line::Kind::curvature, {}};
        follow(sheet, at, first, -1, size / 40, line.points);
        std::ranges::reverse(line.points);
        line.points.push_back(sheet.jet(at[0], at[1]).point);
        follow(sheet, at, first, 1, size / 40, line.points);
        if (line.points.size() > 2) figure.lines.push_back(std::move(line));
      }
    }
}

}  // namespace seam::draw
