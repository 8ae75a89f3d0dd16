// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "check/region.h"

#include <algorithm>
#include <ranges>
#include <utility>

// Why `in_barycentric` keeps signs. Let W = sum l_j w_j and X_i = sum l_j x_ij over the
// corners j of a factor. A point of the factor is x = X / W with W > 0. A part of
// degree t in x becomes, times W^d,  part(X) W^(d-t): no division, and a positive
// multiple of the formula.
//
// Factors are taken from the last on: a function is replaced by its coordinates before anything
// is multiplied out that its rule would reduce, and it stands in no radicand of an earlier one.
//
// Why `contains` is right. By Cramer's rule the l with (1, x) = sum l_j corner_j is
// l_j = det_j / det, det_j with (1, x) in place of corner j. It is the only one, so x lies in
// the simplex exactly when no l_j is negative; its weight sum is 1 > 0 by itself.

namespace seam::check {
namespace {

using certificate::Elementary;

constexpr std::size_t most_corners = 12;  // a determinant takes 2^corners minors

int degree_in(const Monomial& monomial, const std::vector<int>& variables) {
  int sum = 0;
  for (const int variable : variables) sum += exponent(monomial, variable);
  return sum;
}

std::map<int, Polynomial> by_degree(const Polynomial& p, const std::vector<int>& variables,
                                    Meter& meter) {
  std::map<int, Polynomial> parts;
  for (const auto& [monomial, coefficient] : p.terms) {
    meter.charge(variables.size());
    Polynomial& part = parts[degree_in(monomial, variables)];
    part.denominator = p.denominator;
    part.terms.emplace(monomial, coefficient);
  }
  return parts;
}

// sum over the corners of l_j * corner_j[place]
Polynomial coordinate(Context& context, const Factor& factor, std::size_t place) {
  Polynomial total;
  for (std::size_t j = 0; j < factor.corners.size(); ++j)
    add(total,
        context.ring().product(factor.corners[j][place],
                               symbol(factor.first + static_cast<int>(j))),
        context.meter());
  return total;
}

Polynomial in_barycentric(Context& context, const Factor& factor, const Polynomial& formula) {
  Ring& ring = context.ring();
  auto parts = by_degree(formula, factor.variables, context.meter());
  if (parts.empty() || parts.rbegin()->first == 0) return formula;
  for (std::size_t i = 0; i < factor.variables.size(); ++i) {
    const Polynomial value = coordinate(context, factor, i + 1);
    for (auto& [t, part] : parts) part = ring.substitute(part, factor.variables[i], value);
  }
  const Polynomial weight = coordinate(context, factor, 0);
  Polynomial total;
  int reached = 0;
  for (auto& [t, part] : parts) {  // Horner's rule in W, from the lowest degree up
    total = ring.sum(ring.product(total, ring.power(weight, t - reached)), part);
    reached = t;
  }
  return total;
}

Factor make_factor(Context& context, const certificate::Simplex& simplex, int first_symbol) {
  std::vector<int> variables;
  for (const std::string& name : simplex.variables) variables.push_back(context.variable(name));
  std::vector<Coordinates> corners;
  for (const auto& corner : simplex.corners) {
    Coordinates& coordinates = corners.emplace_back();
    for (const certificate::Term term : corner) coordinates.push_back(context.number(term));
  }
  return make_factor(context, std::move(variables), std::move(corners), simplex.open,
                     first_symbol);
}

}  // namespace

Factor make_factor(Context& context, std::vector<int> variables,
                   std::vector<Coordinates> corners, std::vector<bool> open, int first_symbol) {
  demand(corners.size() <= most_corners, "unsupported: a simplex with many corners");
  Factor factor{std::move(variables), std::move(corners), std::move(open)};
  factor.first = first_symbol;
  for (std::size_t j = 0; j < factor.corners.size(); ++j) {
    const int weight = context.tower().sign(factor.corners[j].front());
    demand(weight >= 0, "degenerate: a corner has a negative weight");
    if (weight > 0) factor.finite |= Corners{1} << j;
  }
  factor.orientation = context.tower().sign(determinant(context.ring(), factor.corners));
  demand(factor.orientation != 0, "degenerate: the corners of a simplex are dependent");
  return factor;
}

Region make_region(Context& context, const certificate::Domain& domain,
                   const std::set<int>& others) {
  Region region;
  std::set<int> all;
  int next = context.free_symbol();
  for (const certificate::Simplex& simplex : domain.factors) {
    Factor factor = make_factor(context, simplex, next);
    next += static_cast<int>(factor.corners.size());
    for (const int variable : factor.variables)
      demand(all.insert(variable).second, "degenerate: a variable is named twice");
    region.factors.push_back(std::move(factor));
  }
  all.insert(others.begin(), others.end());
  for (const auto& [formula, relation] : domain.where) {
    region.where.push_back({context.value(formula), relation});
    demand(context.depends_only_on(region.where.back().formula, all),
           "degenerate: a variable outside the domain");
  }
  return region;
}

Region with_functions(Context& context, Region region, const std::set<int>& functions) {
  int next = context.free_symbol();
  for (const Factor& factor : region.factors) next += static_cast<int>(factor.corners.size());
  for (const int function : functions) {
    const Polynomial nil = constant(0), one = constant(1);
    const certificate::Function& stated = context.function(function);
    const bool is_turn =
        stated.elementary == Elementary::cos || stated.elementary == Elementary::sin;
    demand(context.depends_only_on(context.operand(function), variables(region)),
           "degenerate: a variable outside the domain");
    if (stated.elementary == Elementary::log) continue;
    if (is_turn)
      region.factors.push_back(make_factor(
          context, {function}, {{one, constant(-1)}, {one, one}}, {false, false}, next));
    else
      region.factors.push_back(make_factor(context, {function}, {{one, nil}, {nil, one}},
                                           {false, !stated.is_root()}, next));
    next += 2;
    if (stated.is_root())
      region.where.push_back({context.ring().difference(symbol(function, stated.degree),
                                                        context.operand(function)),
                              certificate::Relation::zero});
    if (const auto cosine = context.cosine(function)) {
      Polynomial circle = symbol(function, 2);
      add(circle, symbol(*cosine, 2), context.meter());
      add(circle, constant(-1), context.meter());
      region.where.push_back({std::move(circle), certificate::Relation::zero});
    }
  }
  return region;
}

Region without_lines(Context& context, const Region& region) {
  if (region.lines.empty()) return region;
  Region result{region.factors, {}, {}};
  const std::set<int> bounded = variables(result);
  for (const Condition& condition : region.where)
    if (context.depends_only_on(condition.formula, bounded)) result.where.push_back(condition);
  return result;
}

std::set<int> variables(const Region& region) {
  std::set<int> all = region.lines;
  for (const Factor& factor : region.factors)
    all.insert(factor.variables.begin(), factor.variables.end());
  return all;
}

bool contains(Context& context, const Factor& factor, const Coordinates& values) {
  Coordinates point = {constant(1)};
  point.insert(point.end(), values.begin(), values.end());
  bool inside = true;
  for (std::size_t j = 0; j < factor.corners.size(); ++j) {
    std::vector<Coordinates> rows = factor.corners;
    rows[j] = point;
    const int sign =
        factor.orientation * context.tower().sign(determinant(context.ring(), rows));
    inside = inside && (factor.open[j] ? sign > 0 : sign >= 0);
  }
  return inside;
}

Polynomial in_barycentric(Context& context, const Region& region, Polynomial formula) {
  for (const Factor& factor : std::views::reverse(region.factors))
    formula = in_barycentric(context, factor, formula);
  return formula;
}

// minors[s] is the determinant of the first |s| rows in the columns of the set s.
Polynomial determinant(Ring& ring, const std::vector<Coordinates>& rows) {
  const std::size_t size = rows.size();
  std::vector<Polynomial> minors(std::size_t{1} << size);
  minors[0] = constant(1);
  for (std::size_t set = 1; set < minors.size(); ++set) {
    std::vector<std::size_t> columns;
    for (std::size_t c = 0; c < size; ++c)
      if ((set >> c & 1) != 0) columns.push_back(c);
    const Coordinates& row = rows[columns.size() - 1];
    for (std::size_t k = 0; k < columns.size(); ++k) {
      const std::size_t column = columns[k];
      Polynomial term = ring.product(row[column], minors[set ^ (std::size_t{1} << column)]);
      const bool is_even = (columns.size() - 1 + k) % 2 == 0;
      minors[set] = ring.sum(std::move(minors[set]), is_even ? term : negated(term));
    }
  }
  return std::move(minors.back());
}

}  // namespace seam::check
