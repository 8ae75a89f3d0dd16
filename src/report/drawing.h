// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "report/colour.h"
#include "report/run.h"

namespace seam::report {

/// A figure seen from a fixed place, as a flat picture: parts from back to front, the legend
/// among them. Lengths are in points of 1/72 inch, y upwards, (0, 0) the lower left corner.
/// What the facets hide is left out; lines and marks lie above them.
struct Drawing {
  using Place = std::array<double, 2>;
  struct Polygon {
    std::vector<Place> corners;
    Colour fill{};
  };
  struct Stroke {
    enum class Kind { seam, edge, net, curvature, curve, contour, frame };
    Kind kind = Kind::seam;
    std::vector<Place> points;
  };
  struct Mark {  ///< a ring with a label
    Place at{};
    std::string label;
  };
  struct Text {
    enum class Anchor { left, middle, right };
    Place at{};  ///< of the baseline
    std::string text;
    std::string latex;  ///< the same in mathematics; empty: there is none
    Anchor anchor = Anchor::left;
  };
  using Part = std::variant<Polygon, Stroke, Mark, Text>;

  double width = 0, height = 0;
  std::vector<Part> parts;  ///< none: there is nothing to see
};

Drawing drawing(const FigureRun&);

struct StrokeStyle {
  Colour colour{};
  double width = 0;  ///< points
};
StrokeStyle style_of(Drawing::Stroke::Kind);
/// As a part of a drawing: `net`.
Drawing::Stroke::Kind stroke_kind(FigureRun::Line::Kind);
const char* word(FigureRun::Line::Kind);

/// `Gauss curvature K`, `mean curvature H`, or the expression; empty: not coloured.
std::string legend_title(const FigureRun&);

/// In sentences: what is drawn, by what it is coloured, and that it proves nothing.
std::string description(const FigureRun&);

}  // namespace seam::report
