// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "draw/figure_parts.h"

namespace seam::draw {

void add_curve(report::FigureRun& figure, const geometry::Curve& curve,
               const claims::MeantFigure& meant, const symbolic::Numbers& numbers) {
  using Line = report::FigureRun::Line;
  constexpr int cuts = 60;
  Line net{Line::Kind::net, {}}, line{Line::Kind::curve, {}};
  for (const geometry::Point& control : curve.control) {
    net.points.emplace_back();
    for (std::size_t i = 0; i < control.size() && i < 3; ++i)
      net.points.back()[i] =
          symbolic::is_number(control[i]) ? numbers.approximate(control[i]) : std::nan("");
  }
  for (int k = 0; k <= cuts; ++k) {
    const double u = static_cast<double>(k) / cuts;
    std::vector<Vector> points = net.points;
    for (std::size_t n = points.size(); n > 1; --n)
      for (std::size_t i = 0; i + 1 < n; ++i)
        points[i] = (1 - u) * points[i] + u * points[i + 1];
    line.points.push_back(points[0]);
  }
  figure.lines.push_back(std::move(line));
  if (std::ranges::count(meant.with, "net") > 0) figure.lines.push_back(std::move(net));
}

}  // namespace seam::draw
