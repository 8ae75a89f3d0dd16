// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/drawing.h"

#include <algorithm>
#include <cmath>

#include "report/facing.h"
#include "report/view.h"

// The painter's algorithm: facets that are seen, from the farthest to the nearest. The order is
// by rounded depth, then by place in the list, so that it does not hang on the last bits.

namespace seam::report {
namespace {

using Place = Drawing::Place;
using Stroke = Drawing::Stroke;

constexpr double larger_side = 216;  // points: three inches
constexpr double margin = 6;
constexpr Colour plain = {0.74, 0.79, 0.84};

// Light from the eye, a little from the upper left.
constexpr Vector light = {-0.35, 0.45, 0.8216};

class Painter {
 public:
  explicit Painter(const FigureRun& figure)
      : figure_(figure), view_(figure), scale_(scale_of(figure.values)) {}

  Drawing drawn() {
    if (figure_.triangles.empty() && figure_.lines.empty()) return {};
    const double factor = larger_side / 2;
    bottom_ = figure_.values.empty() ? margin : 44;
    result_.width =
        std::max(2 * factor * view_.half_width(), figure_.values.empty() ? 0 : 240.0) +
        2 * margin;
    result_.height = 2 * factor * view_.half_height() + bottom_ + margin;
    middle_ = {result_.width / 2, bottom_ + factor * view_.half_height()};
    facets();
    lines();
    marks();
    if (!figure_.values.empty()) legend();
    return std::move(result_);
  }

 private:
  Place place(const Vector& seen) const {
    return {middle_[0] + larger_side / 2 * seen[0], middle_[1] + larger_side / 2 * seen[1]};
  }

  void facets() {
    struct Facet {
      std::size_t triangle;  ///< of the figure
      std::size_t seen;
      long depth;
    };
    std::vector<DepthGrid::Triangle> seen;
    std::vector<Facet> order;
    for (std::size_t i = 0; i < figure_.triangles.size(); ++i) {
      const auto& [a, b, c] = figure_.triangles[i];
      const DepthGrid::Triangle at = {view_(figure_.points[a]), view_(figure_.points[b]),
                                      view_(figure_.points[c])};
      const bool looks_here = cross(at[1] - at[0], at[2] - at[0])[2] > 0;
      if (figure_.closed) edges_.add(at, looks_here);
      if (figure_.closed && !looks_here) continue;
      order.push_back({i, seen.size(), std::lround(1e4 * (at[0][2] + at[1][2] + at[2][2]))});
      seen.push_back(at);
    }
    grid_.emplace_back(seen);
    std::ranges::stable_sort(order, {}, &Facet::depth);
    for (const Facet& facet : order) {
      if (!grid_[0].shows(facet.seen)) continue;
      const auto& [a, b, c] = seen[facet.seen];
      result_.parts.emplace_back(Drawing::Polygon{{place(a), place(b), place(c)},
                                                  fill(figure_.triangles[facet.triangle])});
    }
  }

  // Both sides are lit alike; the inner one of an open surface is a little darker.
  Colour fill(const std::array<int, 3>& triangle) const {
    Vector normal{};
    double value = 0;
    for (const int i : triangle) {
      if (!figure_.normals.empty()) normal = normal + figure_.normals[i];
      if (!figure_.values.empty()) value += figure_.values[i] / 3;
    }
    const Vector towards = view_.turned(normal);
    const double size = length(towards);
    const double sign = towards[2] < 0 ? -1 : 1;
    const double lit = size > 0 ? std::max(0.0, sign * dot(towards, light) / size) : 1;
    const double shade = (0.5 + 0.5 * lit) * (sign < 0 && !figure_.closed ? 0.9 : 1);
    Colour result = figure_.values.empty() ? plain : colour(scale_, value);
    for (double& channel : result) channel *= shade;
    return result;
  }

  void lines() {
    for (const auto kind : {FigureRun::Line::Kind::contour, FigureRun::Line::Kind::curvature,
                            FigureRun::Line::Kind::edge, FigureRun::Line::Kind::seam,
                            FigureRun::Line::Kind::net, FigureRun::Line::Kind::curve})
      for (const FigureRun::Line& line : figure_.lines)
        if (line.kind == kind) add(line);
  }

  // What is seen of a line, as strokes. The net of a patch is shown
  // whole.
  void add(const FigureRun::Line& line) {
    Stroke stroke{stroke_kind(line.kind), {}};
    const bool can_hide = figure_.closed || line.kind != FigureRun::Line::Kind::net;
    const auto end = [&] {
      if (stroke.points.size() > 1) result_.parts.emplace_back(stroke);
      stroke.points.clear();
    };
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
      const Vector a = view_(line.points[i]), b = view_(line.points[i + 1]);
      constexpr double finest = 1.0 / 60;
      const bool turned_away = edges_.turn_away(a, b),
                 on_border = !figure_.closed || edges_.face_here(a, b);
      const int parts = std::max(
          1, static_cast<int>(std::ceil(std::hypot(b[0] - a[0], b[1] - a[1]) / finest)));
      for (int k = 0; k < parts; ++k) {
        const auto at = [&](double t) { return (1 - t) * a + t * b; };
        if (turned_away || (can_hide && grid_[0].hides(at((k + 0.5) / parts), on_border))) {
          end();
          continue;
        }
        if (stroke.points.empty()) stroke.points.push_back(place(at(1.0 * k / parts)));
        const Place next = place(at((k + 1.0) / parts));
        if (k > 0 && stroke.points.size() > 1)
          stroke.points.back() = next;  // on one line with the point before
        else
          stroke.points.push_back(next);
      }
    }
    end();
  }

  void marks() {
    for (const FigureRun::Mark& mark : figure_.marks)
      result_.parts.emplace_back(Drawing::Mark{place(view_(mark.at)), mark.label});
  }

  void legend() {
    constexpr double width = 138, bar_low = 14, bar_high = 22;
    constexpr int steps = 46;
    const double left = (result_.width - width) / 2, span = scale_.high - scale_.low;
    const auto x_of = [&](double value) {
      return left + (span > 0 ? (value - scale_.low) / span : 0.5) * width;
    };
    for (int i = 0; i < steps; ++i) {
      const double a = left + width * i / steps, b = left + width * (i + 1) / steps;
      const double value = scale_.low + span * (i + 0.5) / steps;
      result_.parts.emplace_back(Drawing::Polygon{
          {{a, bar_low}, {b, bar_low}, {b, bar_high}, {a, bar_high}}, colour(scale_, value)});
    }
    const auto text = [&](double x, double y, const std::string& what,
                          Drawing::Text::Anchor anchor, const std::string& latex = {}) {
      result_.parts.emplace_back(Drawing::Text{{x, y}, what, latex, anchor});
    };
    using Anchor = Drawing::Text::Anchor;
    double taken = 0;
    for (const double tick : scale_.ticks) {
      result_.parts.emplace_back(
          Stroke{Stroke::Kind::frame, {{x_of(tick), bar_low}, {x_of(tick), bar_low - 3}}});
      const std::string label = short_number(tick);
      const double half = 2.3 * static_cast<double>(label.size());
      if (x_of(tick) - half < taken) continue;  // it would meet the one before
      text(x_of(tick), 3, label, Anchor::middle);
      taken = x_of(tick) + half + 2;
    }
    if (span > 0) {
      text(left - 3, bar_low + 1, (scale_.below ? "≤ " : "") + short_number(scale_.low),
           Anchor::right);
      text(left + width + 3, bar_low + 1,
           (scale_.above ? "≥ " : "") + short_number(scale_.high), Anchor::left);
    }
    const bool word = figure_.coloured_by == "gauss" || figure_.coloured_by == "mean";
    text(result_.width / 2, bar_high + 5, legend_title(figure_), Anchor::middle,
         word ? "" : figure_.coloured_by_latex);
  }

  const FigureRun& figure_;
  View view_;
  Scale scale_;
  std::vector<DepthGrid> grid_;
  FacingEdges edges_;
  Drawing result_;
  Place middle_{};
  double bottom_ = margin;
};

}  // namespace

Drawing drawing(const FigureRun& figure) {
  return Painter(figure).drawn();
}

std::string legend_title(const FigureRun& figure) {
  if (figure.coloured_by == "gauss") return "Gauss curvature K";
  if (figure.coloured_by == "mean")
    return figure.closed ? "mean curvature H, positive where it bulges" : "mean curvature H";
  if (figure.coloured_by == "corners") return "corners of a face";
  return figure.coloured_by;
}

std::string description(const FigureRun& figure) {
  std::string result = "A drawing of samples; it proves nothing.";
  if (figure.triangles.empty() && figure.lines.empty() && figure.note.empty())
    return result + " There is nothing to see.";
  if (figure.coloured_by.empty())
    return result + (figure.note.empty() ? "" : " " + figure.note);
  const Scale scale = scale_of(figure.values);
  result += " Coloured by " + legend_title(figure) + ", from " + short_number(scale.least) +
            " to " + short_number(scale.greatest) + ".";
  if (scale.below || scale.above)
    result += " Values far off have the colour of the nearer end of the scale.";
  return result + (figure.note.empty() ? "" : " " + figure.note);
}

}  // namespace seam::report
