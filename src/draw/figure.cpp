// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/figure.h"

#include <algorithm>

#include "draw/figure_parts.h"

namespace seam::draw {
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

class Sampling {
 public:
  Sampling(const claims::MeantFigure& meant, const symbolic::Numbers& numbers)
      : meant_(meant), numbers_(numbers) {
    figure_.id = meant.id;
    figure_.title = meant.title;
    figure_.at = meant.at;
    if (meant.colour) figure_.coloured_by = meant.colour->text;
    if (meant.colour) figure_.coloured_by_latex = meant.colour->latex;
  }

  report::FigureRun figure() {
    if (!meant_.unsupported.empty()) say("Nothing is drawn: " + meant_.unsupported + ".");
    if (meant_.functions) add_functions(figure_, meant_, numbers_);
    std::vector<Patch> patches;
    for (const claims::Value& value : meant_.values) {
      if (const auto* patch = value.as<Patch>()) {
        if (is_drawable(*patch))
          patches.push_back(*patch);
        else
          say("A patch that holds parameters, or does not lie in space, is left out.");
      }
    }
    if (!patches.empty())
      add_patches(figure_, patches, geometry::seams(patches, numbers_), meant_, numbers_);
    for (const claims::Value& value : meant_.values) add(value);
    finish();
    return std::move(figure_);
  }

 private:
  void add(const claims::Value& value) {
    if (const auto* surface = value.as<geometry::Surface>())
      add_patches(figure_, surface->patches, surface->seams, meant_, numbers_);
    else if (const auto* mesh = value.as<geometry::Mesh>())
      add_mesh(figure_, *mesh, numbers_);
    else if (const auto* curve = value.as<geometry::Curve>())
      add_curve(figure_, *curve, meant_, numbers_);
  }

  void finish() {
    if (figure_.values.size() != figure_.points.size()) {
      if (!figure_.coloured_by.empty() && !figure_.points.empty())
        say("Not all that is shown has such a colour, so none has.");
      figure_.values.clear();
    }
    const std::size_t facets = figure_.triangles.size();
    leave_out_undefined(figure_);
    if (figure_.triangles.size() < facets) say("Where there is no value, it is left out.");
    if (figure_.values.empty()) figure_.coloured_by = figure_.coloured_by_latex = "";
    const bool graph = meant_.functions && meant_.functions->functions[0].size() == 1;
    if (graph || std::ranges::count(meant_.with, "contours") > 0) add_contours(figure_);
  }

  void say(const std::string& sentence) { note(figure_, sentence); }

  const claims::MeantFigure& meant_;
  const symbolic::Numbers& numbers_;
  report::FigureRun figure_;
};

}  // namespace

report::FigureRun sampled(const claims::MeantFigure& figure, const symbolic::Numbers& numbers) {
  return Sampling(figure, numbers).figure();
}

}  // namespace seam::draw
