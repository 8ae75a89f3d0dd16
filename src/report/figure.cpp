// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

// The painter's algorithm: facets that look away are left out, the rest drawn from back to
// front. The order is by rounded depth, then by place in the list, so that it does not hang on
// the last bits.

namespace seam::report {
namespace {

using Vector = std::array<double, 3>;

Vector difference(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// An orthonormal frame: right, up, and towards the eye.
constexpr Vector right = {-0.6, 0.8, 0};
constexpr Vector up = {-0.288, -0.216, 0.9330};
constexpr Vector eye = {0.7464, 0.5598, 0.36};

struct Drawn {
  std::array<std::array<double, 2>, 3> corners;
  long depth = 0;
  double light = 1, value = 0;
};

std::vector<Drawn> visible(const FigureRun& figure) {
  std::vector<Drawn> drawn;
  for (const auto& triangle : figure.triangles) {
    const Vector &a = figure.points[triangle[0]], &b = figure.points[triangle[1]],
                 &c = figure.points[triangle[2]];
    const Vector normal = cross(difference(b, a), difference(c, a));
    const double length = std::sqrt(dot(normal, normal));
    if (!(length > 0) || dot(normal, eye) <= 0) continue;
    Drawn next;
    for (std::size_t i = 0; i < 3; ++i)
      next.corners[i] = {dot(figure.points[triangle[i]], right),
                         dot(figure.points[triangle[i]], up)};
    next.depth = std::lround(1e4 * (dot(a, eye) + dot(b, eye) + dot(c, eye)));
    next.light = 0.55 + 0.45 * dot(normal, eye) / length;
    if (!figure.values.empty())
      for (const int i : triangle) next.value += figure.values[i] / 3;
    drawn.push_back(next);
  }
  std::ranges::stable_sort(drawn, {}, &Drawn::depth);
  return drawn;
}

// From blue over white-green to yellow; rising in lightness, so that it also reads in grey.
Vector colour(double t) {
  constexpr std::array<Vector, 4> stops = {
      {{0.23, 0.30, 0.55}, {0.13, 0.57, 0.55}, {0.48, 0.82, 0.32}, {0.99, 0.91, 0.15}}};
  const double at = std::clamp(t, 0.0, 1.0) * 3;
  const auto stop = std::min<std::size_t>(2, static_cast<std::size_t>(at));
  const double part = at - static_cast<double>(stop);
  Vector mixed{};
  for (std::size_t i = 0; i < 3; ++i)
    mixed[i] = stops[stop][i] * (1 - part) + stops[stop + 1][i] * part;
  return mixed;
}

std::string rgb(const Vector& colour, double light) {
  char buffer[48];
  std::snprintf(buffer, sizeof buffer, "%.2f,%.2f,%.2f", colour[0] * light, colour[1] * light,
                colour[2] * light);
  return buffer;
}

std::string point(double x, double y) {
  char buffer[48];
  std::snprintf(buffer, sizeof buffer, "(%.3f,%.3f)", x, y);
  return buffer;
}

std::string scale(double low, double high) {
  std::string result;
  char buffer[160];
  for (int i = 0; i < 20; ++i) {
    result += "\\definecolor{facet}{rgb}{" + rgb(colour((i + 0.5) / 20), 1) + "}";
    std::snprintf(buffer, sizeof buffer, "\\fill[facet] (%.2f,-3.6) rectangle (%.2f,-3.4);\n",
                  -2 + i * 0.2, -2 + (i + 1) * 0.2 + 0.01);
    result += buffer;
  }
  std::snprintf(buffer, sizeof buffer,
                "\\node[left,font=\\small] at (-2,-3.5) {%.4g};"
                "\\node[right,font=\\small] at (2,-3.5) {%.4g};\n",
                low, high);
  return result + buffer;
}

}  // namespace

std::string picture(const FigureRun& figure) {
  std::vector<Drawn> drawn = visible(figure);
  if (drawn.empty()) return "";

  double reach = 0;
  for (const Drawn& facet : drawn)
    for (const auto& [x, y] : facet.corners)
      reach = std::max({reach, std::abs(x), std::abs(y)});
  const bool coloured = !figure.values.empty();
  const auto [low, high] =
      std::ranges::minmax(coloured ? figure.values : std::vector<double>{0});
  const double span = high - low;

  std::string result = "\\begin{center}\\begin{tikzpicture}[line join=round]\n";
  for (const Drawn& facet : drawn) {
    const double t = span > 1e-9 ? (facet.value - low) / span : 0.5;
    result += "\\definecolor{facet}{rgb}{" +
              rgb(coloured ? colour(t) : Vector{0.62, 0.72, 0.80}, facet.light) +
              "}\\filldraw[facet,line width=0.1pt] ";
    for (const auto& [x, y] : facet.corners)
      result += point(3 * x / reach, 3 * y / reach) + " -- ";
    result += "cycle;\n";
  }
  if (coloured) result += scale(low, high);
  return result + "\\end{tikzpicture}\\end{center}\n";
}

}  // namespace seam::report
