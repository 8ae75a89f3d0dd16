// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>

#include "draw/figure_parts.h"
#include "report/colour.h"

// The triangle of two barycentric coordinates is drawn with equal sides. Heights of a graph are
// brought to half the size of its domain, by a factor of two digits that the figure names.

namespace seam::draw {
namespace {

using report::FigureRun;
using Line = FigureRun::Line;
using Shape = RoundedPatch::Shape;

constexpr int curve_cuts = 200;

// A domain as the image of the unit interval, the unit square, or the standard triangle.
struct RoundedDomain {
  std::vector<std::string> variables;
  std::vector<double> low, size;  ///< by variable
  Shape shape = Shape::square;

  Expansion variable(std::size_t i, double u, double v) const {
    return i == 0 ? Expansion{low[0] + size[0] * u, size[0], 0, 0, 0, 0}
                  : Expansion{low[1] + size[1] * v, 0, size[1], 0, 0, 0};
  }
  std::vector<Expansion> at(double u, double v) const {
    std::vector<Expansion> result;
    for (std::size_t i = 0; i < variables.size(); ++i) result.push_back(variable(i, u, v));
    return result;
  }
  double extent() const { return std::max(size[0], size.back()); }
  // Where a point of the domain lies in the plane.
  std::array<Expansion, 2> place(double u, double v) const {
    Expansion x = variable(0, u, v), y = variable(1, u, v);
    if (shape == Shape::square) return {x, y};
    constexpr double height = 0.8660254037844386;
    return {Expansion{u + v / 2, 1, 0.5, 0, 0, 0}, Expansion{height * v, 0, height, 0, 0, 0}};
  }
};

RoundedDomain rounded(const std::vector<symbolic::Simplex>& domain,
                      const symbolic::Numbers& numbers) {
  RoundedDomain result;
  for (const symbolic::Simplex& simplex : domain)
    for (std::size_t i = 0; i < simplex.variables.size(); ++i) {
      result.variables.push_back(simplex.variables[i]);
      const double from = numbers.approximate(simplex.corners[0][i + 1]);
      const double to = numbers.approximate(simplex.corners[i + 1][i + 1]);
      result.low.push_back(from);
      result.size.push_back(to - from);
      if (simplex.variables.size() == 2) result.shape = Shape::triangle;
    }
  return result;
}

std::vector<RoundedFunction> rounded(const claims::Vector& components,
                                     const RoundedDomain& domain,
                                     const symbolic::Numbers& numbers) {
  std::vector<RoundedFunction> result;
  for (const claims::Scalar& component : components)
    result.emplace_back(claims::formula_of(component), domain.variables, numbers);
  return result;
}

Jet jet_of(const Expansion& x, const Expansion& y, const Expansion& z) {
  return {{x.value, y.value, z.value}, {x.u, y.u, z.u},    {x.v, y.v, z.v},
          {x.uu, y.uu, z.uu},          {x.uv, y.uv, z.uv}, {x.vv, y.vv, z.vv}};
}

// Values far beyond the others are cut off.
struct Heights {
  double low = 0, high = 0, factor = 1;
  report::Scale scale;

  explicit Heights(const std::vector<double>& values, double extent)
      : scale(report::scale_of(values)) {
    low = scale.low;
    high = scale.high;
    if (!(high > low)) return;
    factor = extent / 2 / (high - low);
    if (factor > 0.5 && factor < 2) factor = 1;
    const double digits = std::pow(10, std::floor(std::log10(factor)) - 1);
    factor = std::round(factor / digits) * digits;
  }
  Expansion operator()(const Expansion& f) const {
    if (f.value < low || f.value > high)
      return {factor * (std::clamp(f.value, low, high) - low), 0, 0, 0, 0, 0};
    return {factor * (f.value - low),
            factor * f.u,
            factor * f.v,
            factor * f.uu,
            factor * f.uv,
            factor * f.vv};
  }
  void tell(FigureRun& figure) const {
    if (factor != 1)
      note(figure, "Heights are multiplied by " + report::short_number(factor) + ".");
    if (scale.above || scale.below) note(figure, "Values far off are cut off.");
  }
};

// Round the graphs of functions of one variable.
void add_frame(FigureRun& figure, const RoundedDomain& domain, const Heights& heights) {
  const double left = domain.low[0], right = left + domain.size[0];
  const double top = heights.factor * (heights.high - heights.low);
  figure.lines.push_back(
      {Line::Kind::edge,
       {{left, 0, 0}, {right, 0, 0}, {right, 0, top}, {left, 0, top}, {left, 0, 0}}});
  using report::short_number;
  note(figure, "In the frame " + domain.variables[0] + " runs from " + short_number(left) +
                   " to " + short_number(right) + ", and the values from " +
                   short_number(heights.low) + " to " + short_number(heights.high) + ".");
}

void add_sheet(FigureRun& figure, Facets& facets, const Sheet& sheet, int cuts,
               const Colouring& colouring) {
  facets.add(sheet, cuts, colouring);
  for (int side = 1; side <= (sheet.shape == Shape::triangle ? 3 : 4); ++side)
    figure.lines.push_back(side_line(sheet, side, cuts, Line::Kind::edge));
}

}  // namespace

void add_functions(FigureRun& figure, const claims::MeantFigure& meant,
                   const symbolic::Numbers& numbers) {
  const claims::MeantFigure::Functions& given = *meant.functions;
  const RoundedDomain domain = rounded(given.domain, numbers);
  std::vector<std::vector<RoundedFunction>> functions;
  for (const claims::Vector& function : given.functions)
    functions.push_back(rounded(function, domain, numbers));
  const bool one_variable = domain.variables.size() == 1;
  const int cuts = one_variable ? curve_cuts : cuts_of(functions.size(), domain.shape);

  std::vector<double> values;  // of the graphs
  for (const auto& function : functions)
    for (int j = 0; function.size() == 1 && j <= (one_variable ? 0 : cuts); ++j)
      for (int i = 0; i <= (domain.shape == Shape::triangle ? cuts - j : cuts); ++i)
        values.push_back(
            function[0](domain.at(static_cast<double>(i) / cuts, static_cast<double>(j) / cuts))
                .value);
  const Heights heights(values, domain.extent());
  if (!values.empty()) heights.tell(figure);

  if (one_variable && !values.empty()) add_frame(figure, domain, heights);

  Facets facets(figure);
  for (const auto& function : functions) {
    const auto component = [&](std::size_t i, double u, double v) {
      return i < function.size() ? function[i](domain.at(u, v)) : Expansion{};
    };
    const bool graph = function.size() == 1;
    if (one_variable) {
      Line line{Line::Kind::curve, {}};
      for (int i = 0; i <= cuts; ++i) {
        const double u = static_cast<double>(i) / cuts;
        const Expansion x = component(0, u, 0);
        line.points.push_back(
            graph ? Vector{domain.variable(0, u, 0).value, 0, heights(x).value}
                  : Vector{x.value, component(1, u, 0).value, component(2, u, 0).value});
      }
      figure.lines.push_back(std::move(line));
      continue;
    }
    const auto jet = [&](double u, double v, const auto& height) {
      if (!graph) return jet_of(component(0, u, v), component(1, u, v), component(2, u, v));
      const auto [x, y] = domain.place(u, v);
      return jet_of(x, y, height(component(0, u, v)));
    };
    const Sheet sheet{domain.shape, [&](double u, double v) { return jet(u, v, heights); }};
    // The colour of a graph is that of its true heights.
    const auto number = static_cast<std::size_t>(&function - functions.data());
    const Colouring inner = colouring(
        meant, number, domain.variables, [&](double u, double v) { return domain.at(u, v); },
        numbers);
    const Colouring outer = [&](const Jet&, double u, double v) {
      return inner(jet(u, v, std::identity()), u, v);
    };
    add_sheet(figure, facets, sheet, cuts, inner ? outer : inner);
    if (!graph) continue;
    const Sheet base{domain.shape, [&](double u, double v) {
                       const auto [x, y] = domain.place(u, v);
                       return jet_of(x, y, Expansion{});
                     }};
    for (int side = 1; side <= (domain.shape == Shape::triangle ? 3 : 4); ++side)
      figure.lines.push_back(side_line(base, side, 1, Line::Kind::edge));
  }
}

}  // namespace seam::draw
