// SPDX-License-Identifier: GPL-3.0-or-later
#include "coq/factor.h"

// The points of a simplex are (sum l_i x_i) / (sum l_i w_i) with a denominator > 0; dividing
// all l_i by it makes it 1. Of a segment from a to b, l = (b - x) / (b - a) and
// m = (x - a) / (b - a); of a ray, l = 1; so a facet l_i = 0 that is open is a strict
// inequality, except at infinity, where there is none.

namespace seam::coq {
namespace {

using Shape = Factor::Shape;

Shape shape_of(const certificate::Simplex& simplex, const Formulas& formulas) {
  std::vector<std::vector<std::string>> corners;
  for (const auto& corner : simplex.corners) {
    auto& entries = corners.emplace_back();
    for (const certificate::Term term : corner)
      entries.push_back(formulas.is_constant(term) ? formulas.write(term).text : "?");
  }
  if (corners.size() == 2 && corners[0][0] == "1") {
    if (corners[1][0] == "1") return Shape::segment;
    if (corners[1] == std::vector<std::string>{"0", "1"}) return Shape::ray_up;
    if (corners[1] == std::vector<std::string>{"0", "(-1)"}) return Shape::ray_down;
  }
  const std::vector<std::vector<std::string>> unit = {
      {"1", "0", "0"}, {"1", "1", "0"}, {"1", "0", "1"}};
  return corners == unit ? Shape::triangle : Shape::general;
}

/// lower < upper, or lower <= upper.
Inequality below(const Written& lower, const Written& upper, bool is_strict,
                 const std::string& name) {
  return {name, lower.text + (is_strict ? " < " : " <= ") + upper.text,
          difference(upper, lower), is_strict};
}

}  // namespace

Factor read_factor(const certificate::Simplex& simplex, const Formulas& formulas,
                   Names& names) {
  Factor factor;
  factor.shape = shape_of(simplex, formulas);
  factor.simplex = &simplex;
  for (const std::string& variable : simplex.variables) {
    factor.variables.push_back(names.of(variable));
    factor.equations.push_back(names.fresh(factor.variables.back() + "_is"));
  }
  for (std::size_t i = 0; i < simplex.corners.size(); ++i) {
    factor.coordinates.push_back(names.fresh("l" + std::to_string(i)));
    factor.signs.push_back(names.fresh(factor.coordinates.back() + "_nonnegative"));
    factor.strict.push_back(names.fresh(factor.coordinates.back() + "_positive"));
  }
  factor.sum = names.fresh("sum_is_1");
  return factor;
}

std::vector<Inequality> inequalities(const Factor& factor, const Formulas& formulas,
                                     Names& names) {
  const certificate::Simplex& simplex = *factor.simplex;
  std::vector<Inequality> result;
  const auto add = [&](const Written& lower, const Written& upper, std::size_t facet) {
    result.push_back(below(lower, upper, simplex.open[facet],
                           names.fresh(factor.variables.front() + "_bound")));
  };
  const auto corner = [&](std::size_t i) { return formulas.write(simplex.corners[i][1]); };
  const Written x = formulas.of(simplex.variables.front());
  switch (factor.shape) {
    case Shape::segment:
      add(corner(0), x, 1);
      add(x, corner(1), 0);
      break;
    case Shape::ray_up:
      add(corner(0), x, 1);
      break;
    case Shape::ray_down:
      add(x, corner(0), 1);
      break;
    case Shape::triangle: {
      const Written y = formulas.of(simplex.variables.back());
      add(constant("0"), x, 1);
      add(constant("0"), y, 2);
      add(sum(x, y), constant("1"), 0);
      break;
    }
    case Shape::general:
      break;
  }
  return result;
}

Written weighted_sum(const Factor& factor, const Formulas& formulas) {
  const auto l = [&](std::size_t i) { return formulas.coordinate(factor.coordinates[i]); };
  switch (factor.shape) {
    case Shape::segment:
      return sum(l(0), l(1));
    case Shape::ray_up:
    case Shape::ray_down:
      return l(0);
    case Shape::triangle:
      return sum(sum(l(0), l(1)), l(2));
    case Shape::general:
      break;
  }
  Written total = product(formulas.write(factor.simplex->corners[0][0]), l(0));
  for (std::size_t i = 1; i < factor.coordinates.size(); ++i)
    total = sum(total, product(formulas.write(factor.simplex->corners[i][0]), l(i)));
  return total;
}

Written variable_by_coordinates(const Factor& factor, std::size_t variable,
                                const Formulas& formulas) {
  const auto l = [&](std::size_t i) { return formulas.coordinate(factor.coordinates[i]); };
  const auto share = [&](std::size_t i) {
    return product(formulas.write(factor.simplex->corners[i][variable + 1]), l(i));
  };
  switch (factor.shape) {
    case Shape::ray_up:
      return sum(share(0), l(1));
    case Shape::ray_down:
      return difference(share(0), l(1));
    case Shape::triangle:
      return l(variable + 1);
    case Shape::segment:
    case Shape::general:
      break;
  }
  Written total = share(0);
  for (std::size_t i = 1; i < factor.coordinates.size(); ++i) total = sum(total, share(i));
  return total;
}

}  // namespace seam::coq
