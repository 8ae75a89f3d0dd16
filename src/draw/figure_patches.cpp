// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "draw/figure_parts.h"

// On which side of a side the domain lies, and so whether two patches that share a curve have
// their normals alike: they do if both run round their domains in the same sense and so pass
// the curve in opposite ones.

namespace seam::draw {
namespace {

using report::FigureRun;
using Line = FigureRun::Line;
using Shape = RoundedPatch::Shape;

// Whether a side, in the direction of its growing parameter, runs counterclockwise round the
// domain.
bool runs_counterclockwise(Shape shape, int side) {
  const geometry::Ends ends = geometry::ends(shape, side);
  const int corners = shape == Shape::triangle ? 3 : 4;
  return (ends.from + 1) % corners == ends.to;
}

std::vector<Neighbours> neighbours(const std::vector<RoundedPatch>& patches,
                                   const std::vector<geometry::Seam>& seams) {
  std::vector<Neighbours> result;
  for (const geometry::Seam& seam : seams) {
    const bool first = runs_counterclockwise(patches[seam.patch].shape(), seam.side);
    const bool second =
        runs_counterclockwise(patches[seam.other_patch].shape(), seam.other_side);
    result.push_back({seam.patch, seam.other_patch, (first != second) != seam.reversed});
  }
  return result;
}

void add_net(FigureRun& figure, const RoundedPatch& patch) {
  const auto& net = patch.net();
  const bool triangle = patch.shape() == Shape::triangle;
  const auto add = [&](std::vector<Vector> points) {
    if (points.size() > 1) figure.lines.push_back({Line::Kind::net, std::move(points)});
  };
  for (const auto& row : net) add(row);
  for (std::size_t i = 0; i < net[0].size(); ++i) {
    std::vector<Vector> column, diagonal;
    for (std::size_t j = 0; j < net.size() && i < net[j].size(); ++j)
      column.push_back(net[j][i]);
    add(std::move(column));
    if (!triangle) continue;
    for (std::size_t j = 0; j <= i; ++j) diagonal.push_back(net[j][i - j]);
    add(std::move(diagonal));
  }
}

}  // namespace

void add_patches(FigureRun& figure, const std::vector<geometry::Patch>& given,
                 const std::vector<geometry::Seam>& seams, const claims::MeantFigure& meant,
                 const symbolic::Numbers& numbers) {
  std::vector<RoundedPatch> patches;
  for (const geometry::Patch& patch : given) patches.emplace_back(patch, numbers);

  const auto wants = [&](const char* part) {
    return std::ranges::find(meant.with, part) != meant.with.end();
  };
  Facets facets(figure);
  std::vector<Sheet> sheets;
  for (const RoundedPatch& patch : patches) {
    sheets.push_back({patch.shape(), [&](double u, double v) { return patch.jet(u, v); }});
    const Colouring by = colouring(
        meant, sheets.size() - 1, {geometry::parameter_u, geometry::parameter_v},
        [](double u, double v) {
          return std::vector<Expansion>{{u}, {v}};
        },
        numbers);
    facets.add(sheets.back(), cuts_of(patches.size(), patch.shape()), by);
    if (wants("net")) add_net(figure, patch);
    if (wants("curvature_lines")) add_curvature_lines(figure, sheets.back());
  }

  std::vector<std::array<bool, 5>> on_seam(patches.size());
  const auto add_side = [&](std::size_t patch, int side, Line::Kind kind) {
    const int cuts = cuts_of(patches.size(), patches[patch].shape());
    figure.lines.push_back(side_line(sheets[patch], side, cuts, kind));
  };
  for (const geometry::Seam& seam : seams) {
    if (!on_seam[seam.patch][seam.side]) add_side(seam.patch, seam.side, Line::Kind::seam);
    on_seam[seam.patch][seam.side] = on_seam[seam.other_patch][seam.other_side] = true;
  }
  std::vector<bool> has_free_edge(patches.size());
  for (std::size_t i = 0; i < patches.size(); ++i)
    for (int side = 1; side <= given[i].sides(); ++side)
      if (!on_seam[i][side]) {
        has_free_edge[i] = true;
        add_side(i, side, Line::Kind::edge);
      }
  facets.turn(neighbours(patches, seams), has_free_edge);
}

}  // namespace seam::draw
