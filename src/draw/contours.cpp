// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>

#include "draw/figure_parts.h"
#include "report/colour.h"

// A contour crosses a facet from one edge to another, or not at all, for a corner at the level
// counts as above it. So the crossings are linked to at most two others each, and make chains.

namespace seam::draw {
namespace {

using report::FigureRun;
using Edge = std::pair<int, int>;
using Line = FigureRun::Line;

struct Crossing {
  Vector at{};
  std::vector<Edge> next;
  bool seen = false;
};

std::map<Edge, Crossing> crossings(const FigureRun& figure, double level) {
  std::map<Edge, Crossing> result;
  const auto is_above = [&](int i) { return figure.values[i] >= level; };
  for (const auto& corners : figure.triangles) {
    std::vector<Edge> crossed;
    for (std::size_t k = 0; k < 3; ++k) {
      const Edge edge = std::minmax(corners[k], corners[(k + 1) % 3]);
      if (is_above(edge.first) == is_above(edge.second)) continue;
      const double a = figure.values[edge.first], b = figure.values[edge.second];
      const double t = (level - a) / (b - a);
      result[edge].at = (1 - t) * figure.points[edge.first] + t * figure.points[edge.second];
      crossed.push_back(edge);
    }
    if (crossed.size() != 2) continue;
    result[crossed[0]].next.push_back(crossed[1]);
    result[crossed[1]].next.push_back(crossed[0]);
  }
  return result;
}

Line chain(std::map<Edge, Crossing>& all, Edge at) {
  Line line{Line::Kind::contour, {}};
  for (bool goes_on = true; goes_on;) {
    Crossing& here = all.at(at);
    here.seen = true;
    line.points.push_back(here.at);
    goes_on = false;
    for (const Edge& next : here.next)
      if (!goes_on && !all.at(next).seen) {
        at = next;
        goes_on = true;
      } else if (line.points.size() > 2 && all.at(next).at == line.points.front()) {
        line.points.push_back(line.points.front());
      }
  }
  return line;
}

}  // namespace

void add_contours(FigureRun& figure) {
  if (figure.values.empty()) return;
  for (const double level : report::scale_of(figure.values).ticks) {
    auto all = crossings(figure, level);
    for (const bool open : {true, false})  // chains from their ends, then rings
      for (auto& [edge, crossing] : all)
        if (!crossing.seen && (!open || crossing.next.size() == 1))
          figure.lines.push_back(chain(all, edge));
  }
}

}  // namespace seam::draw
