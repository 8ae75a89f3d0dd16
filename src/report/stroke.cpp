// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing.h"

namespace seam::report {

using Line = FigureRun::Line;
using Stroke = Drawing::Stroke;

StrokeStyle style_of(Stroke::Kind kind) {
  switch (kind) {
    case Stroke::Kind::seam:
      return {{0.08, 0.08, 0.1}, 0.6};
    case Stroke::Kind::edge:
      return {{0.08, 0.08, 0.1}, 0.7};
    case Stroke::Kind::net:
      return {{0.55, 0.1, 0.1}, 0.5};
    case Stroke::Kind::curvature:
      return {{1, 1, 1}, 0.35};
    case Stroke::Kind::curve:
      return {{0.75, 0.1, 0.05}, 1.2};
    case Stroke::Kind::contour:
      return {{0.1, 0.1, 0.1}, 0.4};
    case Stroke::Kind::frame:
      return {{0.2, 0.2, 0.2}, 0.4};
  }
  return {};
}

Stroke::Kind stroke_kind(Line::Kind kind) {
  switch (kind) {
    case Line::Kind::seam:
      return Stroke::Kind::seam;
    case Line::Kind::edge:
      return Stroke::Kind::edge;
    case Line::Kind::net:
      return Stroke::Kind::net;
    case Line::Kind::curvature:
      return Stroke::Kind::curvature;
    case Line::Kind::curve:
      return Stroke::Kind::curve;
    case Line::Kind::contour:
      return Stroke::Kind::contour;
  }
  return Stroke::Kind::frame;
}

const char* word(Line::Kind kind) {
  switch (kind) {
    case Line::Kind::seam:
      return "seam";
    case Line::Kind::edge:
      return "edge";
    case Line::Kind::net:
      return "net";
    case Line::Kind::curvature:
      return "curvature";
    case Line::Kind::curve:
      return "curve";
    case Line::Kind::contour:
      return "contour";
  }
  return "";
}

}  // namespace seam::report
