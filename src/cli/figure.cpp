// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/figure.h"

#include <algorithm>

#include "cli/figure_parts.h"

namespace seam::cli {
namespace {

using geometry::Patch;
using geometry::Point;

bool is_drawable(const Point& point) {
  return point.size() >= 2 && point.size() <= 3 &&
         std::ranges::all_of(point, [](const auto& x) { return symbolic::is_number(x); });
}

bool is_drawable(const Patch& patch) {
  return std::ranges::all_of(patch.rows(), [](const auto& row) {
    return std::ranges::all_of(row, [](const Point& p) { return is_drawable(p); });
  });
}

void add(report::FigureRun& result, const claims::Value& value,
         const symbolic::Numbers& numbers) {
  if (const auto* patch = value.as<Patch>(); patch && is_drawable(*patch))
    add_patches(result, {*patch}, {}, {}, numbers);
  else if (const auto* surface = value.as<geometry::Surface>())
    add_patches(result, surface->patches, surface->seams, {}, numbers);
  else if (const auto* mesh = value.as<geometry::Mesh>())
    add_mesh(result, *mesh, numbers);
}

}  // namespace

report::FigureRun sampled(const claims::MeantFigure& figure, const symbolic::Numbers& numbers) {
  report::FigureRun result;
  result.title = figure.title;
  result.coloured_by = figure.coloured_by;
  if (figure.value) add(result, *figure.value, numbers);
  if (result.values.empty()) result.coloured_by.clear();
  leave_out_undefined(result);
  return result;
}

}  // namespace seam::cli
