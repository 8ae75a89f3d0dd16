// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/facets.h"

#include <algorithm>
#include <cmath>
#include <queue>

// The volume under a closed surface is the sum of the signed volumes of the pyramids from the
// origin to its facets; it is positive if they are turned outwards, wherever the origin is.

namespace seam::draw {
namespace {

using report::FigureRun;
using Line = FigureRun::Line;

// A jet with a normal: where there is none (a corner where a side has shrunk to a point), that
// of a place nearby.
Jet jet_near(const Sheet& sheet, double u, double v) {
  const Jet here = sheet.jet(u, v);
  const double middle = sheet.shape == RoundedPatch::Shape::triangle ? 1.0 / 3 : 0.5;
  for (const double step : {0.0, 1e-4, 1e-3}) {
    Jet near = step > 0 ? sheet.jet(u + step * (middle - u), v + step * (middle - v)) : here;
    near.point = here.point;
    const double size = length(near.u) * length(near.v);
    if (length(near.normal()) > 1e-7 * size && size > 0) return near;
  }
  return here;
}

}  // namespace

void Facets::begin_face() {
  faces_.push_back({figure_.points.size(), figure_.triangles.size()});
}

int Facets::point(const Vector& at, const Vector& normal) {
  figure_.points.push_back(at);
  figure_.normals.push_back(report::direction(normal));
  return static_cast<int>(figure_.points.size()) - 1;
}

void Facets::add(const Sheet& sheet, int cuts, const Colouring& colouring) {
  begin_face();
  const bool triangle = sheet.shape == RoundedPatch::Shape::triangle;
  std::vector<std::vector<int>> grid;
  for (int j = 0; j <= cuts; ++j) {
    grid.emplace_back();
    for (int i = 0; i <= (triangle ? cuts - j : cuts); ++i) {
      const double u = static_cast<double>(i) / cuts, v = static_cast<double>(j) / cuts;
      const Jet jet = jet_near(sheet, u, v);
      grid.back().push_back(point(jet.point, jet.normal()));
      if (colouring) figure_.values.push_back(colouring(jet, u, v));
    }
  }
  for (int j = 0; j < cuts; ++j)
    for (int i = 0; i < (triangle ? cuts - j : cuts); ++i) {
      this->triangle(grid[j][i], grid[j][i + 1], grid[j + 1][i]);
      if (!triangle || i + j < cuts - 1)
        this->triangle(grid[j][i + 1], grid[j + 1][i + 1], grid[j + 1][i]);
    }
}

Facets::First Facets::end(std::size_t face) const {
  return face + 1 < faces_.size() ? faces_[face + 1]
                                  : First{figure_.points.size(), figure_.triangles.size()};
}

void Facets::turn(std::size_t face) {
  for (std::size_t i = faces_[face].triangle; i < end(face).triangle; ++i)
    std::swap(figure_.triangles[i][1], figure_.triangles[i][2]);
  for (std::size_t i = faces_[face].point; i < end(face).point; ++i) {
    figure_.normals[i] = -1.0 * figure_.normals[i];
    if (figure_.coloured_by == "mean") figure_.values[i] = -figure_.values[i];
  }
}

double Facets::volume(std::size_t face) const {
  double result = 0;
  for (std::size_t i = faces_[face].triangle; i < end(face).triangle; ++i) {
    const auto& [a, b, c] = figure_.triangles[i];
    result += dot(figure_.points[a], cross(figure_.points[b], figure_.points[c]));
  }
  return result;
}

void Facets::turn(const std::vector<Neighbours>& neighbours,
                  const std::vector<bool>& has_free_edge) {
  std::vector<std::vector<std::pair<int, bool>>> around(faces_.size());
  for (const auto& [face, other, alike] : neighbours) {
    around[face].emplace_back(other, alike);
    around[other].emplace_back(face, alike);
  }
  figure_.closed = !faces_.empty() && std::ranges::count(has_free_edge, true) == 0;
  std::vector<bool> seen(faces_.size()), turned(faces_.size());
  for (std::size_t start = 0; start < faces_.size(); ++start) {
    if (seen[start]) continue;
    seen[start] = true;
    std::vector<std::size_t> sheet = {start};
    bool closes = true;
    double sum = 0;
    for (std::size_t next = 0; next < sheet.size(); ++next) {
      const std::size_t face = sheet[next];
      if (turned[face]) turn(face);
      closes = closes && !has_free_edge[face];
      sum += volume(face);
      for (const auto& [other, alike] : around[face]) {
        if (seen[other]) continue;
        seen[other] = true;
        turned[other] = alike == turned[face];
        sheet.push_back(other);
      }
    }
    if (closes && sum < 0)
      for (const std::size_t face : sheet) turn(face);
  }
  // Of closed surfaces the mean curvature is taken towards the inside, so that a sphere has a
  // positive one.
  if (figure_.closed && figure_.coloured_by == "mean")
    for (double& value : figure_.values) value = -value;
}

int cuts_of(std::size_t sheets, RoundedPatch::Shape shape) {
  constexpr double facets = 4400;
  const double each = facets / static_cast<double>(std::max<std::size_t>(1, sheets)) /
                      (shape == RoundedPatch::Shape::triangle ? 1 : 2);
  return std::clamp(static_cast<int>(std::sqrt(each)), 3, 40);
}

Line side_line(const Sheet& sheet, int side, int cuts, Line::Kind kind) {
  Line line{kind, {}};
  for (int i = 0; i <= cuts; ++i) {
    const double t = static_cast<double>(i) / cuts;
    const bool triangle = sheet.shape == RoundedPatch::Shape::triangle;
    const double u = side == 1 || (side == 3 && !triangle) ? t
                     : side == 2                           ? 0
                     : side == 3                           ? 1 - t
                                                           : 1;
    const double v = side == 1 ? 0 : side == 3 && !triangle ? 1 : t;
    line.points.push_back(sheet.jet(u, v).point);
  }
  return line;
}

void note(FigureRun& figure, const std::string& sentence) {
  if (figure.note.find(sentence) != std::string::npos) return;
  figure.note += (figure.note.empty() ? "" : " ") + sentence;
}

void leave_out_undefined(FigureRun& figure) {
  const auto is_defined = [&](int i) {
    return report::is_drawable(figure.points[i]) && report::is_drawable(figure.normals[i]) &&
           (figure.values.empty() || std::isfinite(figure.values[i]));
  };
  std::erase_if(figure.triangles, [&](const auto& triangle) {
    return !std::ranges::all_of(triangle, is_defined);
  });
  std::vector<int> place(figure.points.size(), -1);
  FigureRun kept;
  for (auto& triangle : figure.triangles)
    for (int& i : triangle) {
      if (place[i] < 0) {
        place[i] = static_cast<int>(kept.points.size());
        kept.points.push_back(figure.points[i]);
        kept.normals.push_back(figure.normals[i]);
        if (!figure.values.empty()) kept.values.push_back(figure.values[i]);
      }
      i = place[i];
    }
  for (const Line& line : figure.lines) {
    Line piece{line.kind, {}};
    const auto end_piece = [&] {
      if (piece.points.size() > 1) kept.lines.push_back(piece);
      piece.points.clear();
    };
    for (const Vector& point : line.points)
      report::is_drawable(point) ? piece.points.push_back(point) : end_piece();
    end_piece();
  }
  figure.points = std::move(kept.points);
  figure.normals = std::move(kept.normals);
  figure.values = std::move(kept.values);
  figure.lines = std::move(kept.lines);
}

}  // namespace seam::draw
