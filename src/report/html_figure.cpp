// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/html_figure.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "report/colour.h"
#include "report/drawing.h"
#include "report/html_escape.h"
#include "report/html_parts.h"
#include "report/svg.h"

// The samples go into the page as base64 of little-endian numbers: positions within the unit
// ball as 16-bit fractions, colours as bytes, corners of triangles as 16-bit indices. What has
// more points than these can tell apart is shown as a picture only.

namespace seam::report {
namespace {

using Point = FigureRun::Point;

constexpr std::size_t most_points = 65535;
constexpr double mark_size = 0.06;

class Base64 {
 public:
  void byte(unsigned value) {
    pending_ = pending_ << 8 | (value & 0xFF);
    if (++count_ == 3) flush();
  }
  void number(int value) {
    byte(static_cast<unsigned>(value));
    byte(static_cast<unsigned>(value) >> 8);
  }
  void fraction(double value) {
    number(static_cast<int>(std::lround(std::clamp(value, -1.0, 1.0) * 32767)));
  }
  void point(const Point& p) {
    for (const double x : p) fraction(x);
  }
  std::string text() {
    const int missing = count_ == 0 ? 0 : 3 - count_;
    for (int i = 0; i < missing; ++i) byte(0);
    for (int i = 0; i < missing; ++i) text_[text_.size() - 1 - i] = '=';
    return text_;
  }

 private:
  void flush() {
    static constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    for (int shift = 18; shift >= 0; shift -= 6) text_ += digits[pending_ >> shift & 63];
    pending_ = 0;
    count_ = 0;
  }
  std::string text_;
  std::uint32_t pending_ = 0;
  int count_ = 0;
};

// Moves the figure into the unit ball around 0.
class Frame {
 public:
  explicit Frame(const FigureRun& figure) {
    Point low{}, high{};
    bool first = true;
    const auto see = [&](const Point& p) {
      for (std::size_t i = 0; i < 3; ++i) {
        low[i] = first ? p[i] : std::min(low[i], p[i]);
        high[i] = first ? p[i] : std::max(high[i], p[i]);
      }
      first = false;
    };
    for (const Point& p : figure.points) see(p);
    for (const auto& line : figure.lines)
      for (const Point& p : line.points) see(p);
    for (std::size_t i = 0; i < 3; ++i) centre_[i] = (low[i] + high[i]) / 2;
    double reach = 0;
    const auto measure = [&](const Point& p) {
      reach =
          std::max(reach, std::hypot(p[0] - centre_[0], p[1] - centre_[1], p[2] - centre_[2]));
    };
    for (const Point& p : figure.points) measure(p);
    for (const auto& line : figure.lines)
      for (const Point& p : line.points) measure(p);
    if (reach > 0) scale_ = 1 / reach;
  }
  Point operator()(const Point& p) const {
    Point moved{};
    for (std::size_t i = 0; i < 3; ++i) moved[i] = (p[i] - centre_[i]) * scale_;
    return moved;
  }

 private:
  Point centre_{};
  double scale_ = 1;
};

std::string colours(const FigureRun& figure) {
  const Scale scale = scale_of(figure.values);
  Base64 bytes;
  for (std::size_t i = 0; i < figure.points.size(); ++i) {
    const Colour shade =
        figure.values.empty() ? Colour{0.62, 0.72, 0.80} : colour(scale, figure.values[i]);
    for (const double part : shade)
      bytes.byte(static_cast<unsigned>(std::lround(255 * std::clamp(part, 0.0, 1.0))));
  }
  return bytes.text();
}

// The ends of all segments; a mark is three short ones that cross.
std::string lines(const FigureRun& figure, const Frame& frame) {
  Base64 ends;
  for (const auto& line : figure.lines)
    for (std::size_t i = 1; i < line.points.size(); ++i) {
      ends.point(frame(line.points[i - 1]));
      ends.point(frame(line.points[i]));
    }
  for (const auto& mark : figure.marks)
    for (std::size_t i = 0; i < 3; ++i)
      for (const double way : {-mark_size, mark_size}) {
        Point end = frame(mark.at);
        end[i] += way;
        ends.point(end);
      }
  return ends.text();
}

std::string mesh(const FigureRun& figure) {
  const Frame frame(figure);
  Base64 points, normals, corners;
  for (const Point& p : figure.points) points.point(frame(p));
  for (const Point& n : figure.normals) normals.point(n);
  for (const auto& triangle : figure.triangles)
    for (const int corner : triangle) corners.number(corner);
  return R"({"points":")" + points.text() + R"(","normals":")" + normals.text() +
         R"(","colours":")" + colours(figure) + R"(","triangles":")" + corners.text() +
         R"(","lines":")" + lines(figure, frame) + R"("})";
}

std::string hex(const Colour& shade) {
  std::string text = "#";
  for (const double part : shade) {
    const auto value = static_cast<unsigned>(std::lround(255 * std::clamp(part, 0.0, 1.0)));
    text += "0123456789abcdef"[value >> 4];
    text += "0123456789abcdef"[value & 15];
  }
  return text;
}

// What the picture's own legend says, for the view that takes its place.
std::string legend(const FigureRun& figure) {
  if (figure.values.empty()) return "";
  const Scale scale = scale_of(figure.values);
  std::string stops;
  for (int i = 0; i <= 10; ++i)
    stops += ", " + hex(colour(scale, scale.low + (scale.high - scale.low) * i / 10));
  return html_element(
      "div class=\"legend\" hidden=\"hidden\"",
      html_element("span", html_escape(legend_title(figure))) +
          html_element("span", (scale.below ? "≤ " : "") + short_number(scale.low)) +
          html_element(
              "span class=\"bar\" style=\"background: linear-gradient(to right" + stops + ")\"",
              "") +
          html_element("span", (scale.above ? "≥ " : "") + short_number(scale.high)));
}

}  // namespace

std::string html_figure(const FigureRun& figure) {
  const std::string still = svg(figure);
  if (still.empty()) return "";
  const bool turns = !figure.triangles.empty() && figure.points.size() <= most_points &&
                     figure.normals.size() == figure.points.size();
  std::string content = html_element("div class=\"still\"", still) + "\n";
  if (turns)
    content +=
        html_element("script type=\"application/json\" class=\"mesh\"", mesh(figure)) + "\n";
  content += legend(figure);
  std::string caption = html_element("strong", html_escape(figure.title));
  if (!figure.at.empty())
    caption += " " + html_element("span class=\"quiet\"", html_escape(figure.at));
  caption += " " + html_element("span class=\"quiet about\"", html_escape(description(figure)));
  for (const auto& mark : figure.marks) caption += " " + html_link(mark.label);
  return html_element("figure" + std::string(turns ? " class=\"surface\"" : "") +
                          " data-title=\"" + html_escape(figure.title) + "\"",
                      "\n" + content + html_element("figcaption", caption)) +
         "\n";
}

}  // namespace seam::report
