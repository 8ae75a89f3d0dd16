// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/view.h"

#include <algorithm>
#include <limits>

namespace seam::report {
namespace {

constexpr double nothing = -std::numeric_limits<double>::infinity();

template <class F>
void each_point(const FigureRun& figure, const F& f) {
  for (const auto& triangle : figure.triangles)
    for (const int i : triangle) f(figure.points[i]);
  for (const auto& line : figure.lines)
    for (const Vector& point : line.points) f(point);
}

struct Bounds {
  Vector low, high;
  Bounds() {
    low.fill(-nothing);
    high.fill(nothing);
  }
  void add(const Vector& point) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], point[i]);
      high[i] = std::max(high[i], point[i]);
    }
  }
};

int cell_of(double coordinate, int cells) {
  return static_cast<int>(std::floor((coordinate + 1) / 2 * cells));
}

}  // namespace

View::View(const FigureRun& figure) {
  Bounds box;
  each_point(figure, [&](const Vector& point) { box.add(point); });
  const Vector extent = box.high - box.low;
  const double most = std::max({extent[0], extent[1], extent[2]});
  const auto is_flat = [&](std::size_t i) { return extent[i] <= 1e-9 * most; };
  right_ = {-0.6, 0.8, 0};
  up_ = {-0.4, -0.3, std::sqrt(0.75)};
  eye_ = {0.8 * std::sqrt(0.75), 0.6 * std::sqrt(0.75), 0.5};
  if (is_flat(2)) {
    right_ = {1, 0, 0};
    up_ = {0, 1, 0};
    eye_ = {0, 0, 1};
  } else if (is_flat(1)) {
    right_ = {1, 0, 0};
    up_ = {0, 0, 1};
    eye_ = {0, -1, 0};
  } else if (is_flat(0)) {
    right_ = {0, 1, 0};
    up_ = {0, 0, 1};
    eye_ = {1, 0, 0};
  }
  Bounds seen;
  each_point(figure, [&](const Vector& point) { seen.add(turned(point)); });
  middle_ = 0.5 * (seen.low + seen.high);
  const Vector half = 0.5 * (seen.high - seen.low);
  const double larger = std::max(half[0], half[1]);
  factor_ = larger > 0 ? 1 / larger : 1;
  half_ = {half[0] * factor_, half[1] * factor_};
}

Vector View::turned(const Vector& d) const {
  return {dot(d, right_), dot(d, up_), dot(d, eye_)};
}

Vector View::operator()(const Vector& point) const {
  return factor_ * (turned(point) - middle_);
}

// A cell takes the depth of the triangle at its middle; a triangle smaller than a cell takes
// the cell of its first corner.
DepthGrid::DepthGrid(const std::vector<Triangle>& triangles)
    : depth_(cells * cells, nothing), seen_(triangles.size()) {
  std::vector<int> owner(cells * cells, -1);
  const auto put = [&](int x, int y, double depth, std::size_t triangle) {
    if (x < 0 || y < 0 || x >= cells || y >= cells) return;
    double& nearest = depth_[y * cells + x];
    if (depth <= nearest) return;
    nearest = depth;
    owner[y * cells + x] = static_cast<int>(triangle);
  };
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    put(cell_of(a[0], cells), cell_of(a[1], cells), a[2], t);
    const double area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if (area == 0) continue;
    const auto [x0, x1] = std::minmax({a[0], b[0], c[0]});
    const auto [y0, y1] = std::minmax({a[1], b[1], c[1]});
    for (int j = cell_of(y0, cells); j <= cell_of(y1, cells); ++j)
      for (int i = cell_of(x0, cells); i <= cell_of(x1, cells); ++i) {
        const double x = 2 * (i + 0.5) / cells - 1, y = 2 * (j + 0.5) / cells - 1;
        const double s = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area;
        const double r = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area;
        if (s >= 0 && r >= 0 && s + r <= 1)
          put(i, j, a[2] + s * (b[2] - a[2]) + r * (c[2] - a[2]), t);
      }
  }
  for (const int t : owner)
    if (t >= 0) seen_[t] = true;
}

bool DepthGrid::hides(const Vector& point, bool all_round) const {
  constexpr double thickness = 0.02;
  const int x = cell_of(point[0], cells), y = cell_of(point[1], cells);
  const int around = all_round ? 1 : 0;
  for (int j = std::max(0, y - around); j <= std::min(cells - 1, y + around); ++j)
    for (int i = std::max(0, x - around); i <= std::min(cells - 1, x + around); ++i)
      if (depth_[j * cells + i] <= point[2] + thickness) return false;
  return x >= 0 && y >= 0 && x < cells && y < cells;
}

}  // namespace seam::report
