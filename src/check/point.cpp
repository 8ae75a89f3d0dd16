// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "check/point.h"

#include "check/relation.h"

namespace seam::check {

Point read_point(Context& context, const certificate::Point& named) {
  Point point;
  for (std::size_t i = 0; i < named.variables.size(); ++i)
    demand(point.emplace(context.variable(named.variables[i]), context.number(named.values[i]))
               .second,
           "a point has two values for one variable");
  return point;
}

Polynomial value_at(Context& context, Polynomial formula, const Point& point) {
  for (const auto& [variable, value] : point)
    formula = context.ring().substitute(formula, variable, value);
  demand(context.depends_only_on(formula, {}), "a point lacks a value for a variable");
  return formula;
}

void demand_inside(Context& context, const Region& region, const std::set<int>& functions,
                   const Point& point) {
  for (const int function : functions) {
    demand(point.contains(function), "a point lacks a value for a function");
    const Polynomial& value = point.at(function);
    const Polynomial operand = value_at(context, context.operand(function), point);
    const certificate::Function& stated = context.function(function);
    if (!stated.is_root()) {
      demand(context.tower().is_value(stated.elementary, operand, value),
             "a value at a point is not seen to be that of its function");
      continue;
    }
    const Polynomial power = context.ring().power(value, stated.degree);
    demand(context.tower().sign(value) >= 0 &&
               context.tower().sign(context.ring().difference(power, operand)) == 0,
           "a value at a point is not the root that its function is");
  }
  for (const Factor& factor : region.factors) {
    Coordinates values;
    for (const int variable : factor.variables) {
      demand(point.contains(variable), "a point lacks a value for a variable");
      values.push_back(point.at(variable));
    }
    demand(contains(context, factor, values), "a point lies outside the domain");
  }
  for (const auto& [formula, relation] : region.where)
    demand(holds(relation, context.tower().sign(value_at(context, formula, point))),
           "a point breaks a condition of the domain");
}

}  // namespace seam::check
