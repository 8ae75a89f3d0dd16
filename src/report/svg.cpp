// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "report/drawing.h"
#include "report/html_escape.h"

// A facet has a border of its own colour, so that no gaps show between facets: `color` says it
// once for both.

namespace seam::report {
namespace {

std::string number(double x) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.4g", std::round(100 * x) / 100 + 0.0);
  return buffer.data();
}

std::string hex(const Colour& colour) {
  std::array<char, 8> buffer{};
  const auto channel = [&](int i) {
    return static_cast<unsigned>(std::lround(255 * std::min(1.0, std::max(0.0, colour[i]))));
  };
  std::snprintf(buffer.data(), buffer.size(), "#%02x%02x%02x", channel(0), channel(1),
                channel(2));
  return buffer.data();
}

class Writer {
 public:
  explicit Writer(double height) : height_(height) {}

  std::string operator()(const Drawing::Polygon& polygon) const {
    return "<path color=\"" + hex(polygon.fill) + "\" d=\"" + path(polygon.corners) + "z\"/>\n";
  }
  std::string operator()(const Drawing::Stroke& stroke) const {
    const StrokeStyle style = style_of(stroke.kind);
    return "<path fill=\"none\" color=\"" + hex(style.colour) + "\" stroke-width=\"" +
           number(style.width) + "\" d=\"" + path(stroke.points) + "\"/>\n";
  }
  std::string operator()(const Drawing::Mark& mark) const {
    return "<circle fill=\"none\" color=\"#c1121f\" stroke-width=\"1.5\" cx=\"" +
           number(mark.at[0]) + "\" cy=\"" + number(height_ - mark.at[1]) + "\" r=\"4\"/>\n" +
           "<text class=\"mark\" x=\"" + number(mark.at[0] + 6) + "\" y=\"" +
           number(height_ - mark.at[1] + 3) + "\">" + html_escape(mark.label) + "</text>\n";
  }
  std::string operator()(const Drawing::Text& text) const {
    using Anchor = Drawing::Text::Anchor;
    const char* anchor = text.anchor == Anchor::left    ? "start"
                         : text.anchor == Anchor::right ? "end"
                                                        : "middle";
    return "<text text-anchor=\"" + std::string(anchor) + "\" x=\"" + number(text.at[0]) +
           "\" y=\"" + number(height_ - text.at[1]) + "\">" + html_escape(text.text) +
           "</text>\n";
  }

 private:
  std::string path(const std::vector<Drawing::Place>& points) const {
    std::string result;
    for (const auto& [x, y] : points)
      result += (result.empty() ? "M" : " ") + number(x) + " " + number(height_ - y);
    return result;
  }

  double height_;
};

}  // namespace

std::string svg(const FigureRun& figure) {
  const Drawing drawn = drawing(figure);
  const std::string width = number(drawn.width), height = number(drawn.height);
  std::string result = "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"" +
                       width + "pt\" height=\"" + height + "pt\" viewBox=\"0 0 " + width + " " +
                       height + "\">\n<title>" + html_escape(figure.title) +
                       "</title>\n<desc>" + html_escape(description(figure)) +
                       "</desc>\n<style>text{font:8px sans-serif;fill:#222;stroke:none}"
                       ".mark{stroke:#fff;stroke-width:2px;paint-order:stroke}</style>\n"
                       "<g fill=\"currentColor\" stroke=\"currentColor\" stroke-width=\"0.7\" "
                       "stroke-linejoin=\"round\" stroke-linecap=\"round\">\n";
  const Writer writer(drawn.height);
  for (const Drawing::Part& part : drawn.parts) result += std::visit(writer, part);
  return result + "</g>\n</svg>\n";
}

}  // namespace seam::report
