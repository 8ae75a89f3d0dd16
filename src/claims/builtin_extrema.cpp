// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "claims/builtin.h"
#include "claims/extremum_search.h"
#include "claims/stating.h"

// An extremum over a continuous domain stays unresolved: a comparison with it is a statement
// for all (some) points. Where its value itself is wanted, it is taken at a point that a search
// finds; that it is attained there, and nowhere larger, become side statements.

namespace seam::claims {
namespace {

using geometry::Patch;
using symbolic::Simplex;

constexpr std::size_t most_points = 64;  // of argmax

symbolic::Domain domain_of(const Field& field) {
  const std::vector<std::string> names = {geometry::parameter_u, geometry::parameter_v};
  if (field.shape == Patch::Shape::triangle) return {{symbolic::standard_simplex(names)}, {}};
  return {{symbolic::interval(names[0], 0, 1), symbolic::interval(names[1], 0, 1)}, {}};
}

// max(E for u in [0,1], (v,w) in triangle).
Value over_bindings(const Call& call, bool maximum) {
  const Expression& each = call[0];
  Scope inner{&call.scope, {}};
  Extremum::Part part{0, bound_domain(call, each.children.size() - 1, inner)};
  part.value = call.evaluator.scalar(each.children[0], inner);
  return {Extremum{maximum, {part}}};  // its symbols stay in use: the value may be kept
}

bool is_finite(const Call& call) {
  const Expression& each = call[0];
  for (std::size_t k = 1; k < each.children.size(); ++k) {
    const Expression& binding = each.children[k];
    if (binding.children.size() < 2) return false;
    const Expression& set = binding.children[1];
    if (call.evaluator.is_interval(set, call.scope)) return false;
    if (!call.evaluator.finite_set(set, call.scope)) return false;
  }
  return true;
}

Value extremum(const Call& call, bool maximum) {
  std::vector<Value> values;
  if (call[0].kind == Expression::Kind::each) {
    if (!is_finite(call)) return over_bindings(call, maximum);
    values = comprehension(call.evaluator, call[0], call.scope);
  } else if (call.count() > 1) {
    for (std::size_t i = 0; i < call.count(); ++i) values.push_back(call.value(i));
  } else {
    const Value value = call.value(0);
    if (const auto* field = value.as<Field>())
      return {Extremum{maximum, {part_of(*field, call[0])}}};
    if (const auto* surface = value.as<SurfaceField>()) {
      Extremum result{maximum, {}};
      for (const Field& field : surface->fields)
        result.parts.push_back(part_of(field, call[0]));
      return {result};
    }
    values = as_items(call.evaluator, value, call[0]);
  }
  if (values.empty()) fail(call[0], "the extremum of nothing");
  // Extrema over domains join to one; numbers are compared at once.
  if (std::ranges::any_of(values, [](const Value& v) { return v.as<Extremum>() != nullptr; })) {
    Extremum result{maximum, {}};
    for (const Value& value : values) {
      const auto* part = value.as<Extremum>();
      if (!part || part->maximum != maximum)
        throw Unsupported("an extremum of extrema of both kinds");
      result.parts.insert(result.parts.end(), part->parts.begin(), part->parts.end());
    }
    return {result};
  }
  std::vector<Formula> numbers;
  for (const Value& value : values)
    numbers.push_back(as_number(call.evaluator, value, call[0]));
  return {Scalar(greatest(call.evaluator, numbers, maximum))};
}

Value max(const Call& call) {
  return extremum(call, true);
}
Value min(const Call& call) {
  return extremum(call, false);
}

// The squared distance from a point.
Formula distance2(const std::map<std::string, Formula>& point) {
  Formula total = 0;
  for (const auto& [name, coordinate] : point)
    total += symbolic::power(Formula::symbol(name) - coordinate, 2);
  return total;
}

// argmax(E for (u,v) in triangle): the points, each (u, v). That the value is attained there is
// computed; that it is attained nowhere else is stated as a strict inequality where no point of
// the list is.
Value arguments_of_extremum(const Call& call, bool maximum) {
  const Value value = extremum(call, maximum);
  const auto* found = value.as<Extremum>();
  if (!found || found->parts.size() != 1)
    throw Unsupported("argmax and argmin are covered for one function on one domain");
  const Extremum::Part& part = found->parts[0];
  const std::vector<Attained> best = attained(call.evaluator, *found, most_points);
  Extremum elsewhere = *found;
  List points;
  for (const Attained& place : best) {
    elsewhere.parts[0].domain.where.push_back({distance2(place.point), Relation::positive});
    Vector point;
    for (const Simplex& factor : part.domain.factors)
      for (const std::string& variable : factor.variables)
        point.emplace_back(place.point.at(variable));
    points.items.push_back(point.size() == 1 ? Value{point[0]} : Value{point});
  }
  Stating stating(call.evaluator);
  Proposition less =
      stating.everywhere(call.at, elsewhere, maximum ? "<" : ">", Scalar(best[0].value), {},
                         is_oblique(call.evaluator, *found));
  less.about = maximum ? "less everywhere else" : "more everywhere else";
  for (const Attained& place : best) stating.state_attained(call.at, place);
  stating.guards.push_back(std::move(less));
  for (auto& guard : stating.guards) call.evaluator.sides.push_back(std::move(guard));
  return {points};
}

Value argmax(const Call& call) {
  return arguments_of_extremum(call, true);
}
Value argmin(const Call& call) {
  return arguments_of_extremum(call, false);
}

}  // namespace

Extremum::Part part_of(const Field& field, const Expression& at) {
  if (field.components.size() != 1)
    fail(at, "an extremum of a vector: take norm2 or a coordinate");
  return {field.components[0], domain_of(field)};
}

bool is_compact(const symbolic::Domain& domain) {
  return domain.where.empty() && std::ranges::all_of(domain.factors, [](const Simplex& factor) {
           return std::ranges::none_of(factor.open, [](bool open) { return open; }) &&
                  std::ranges::none_of(factor.corners,
                                       [](const auto& c) { return c[0].is(0); });
         });
}

symbolic::Domain bound_domain(const Call& call, std::size_t bindings, Scope& inner) {
  const Expression& each = call[0];
  symbolic::Domain domain;
  for (std::size_t k = 1; k <= bindings; ++k) {
    const Expression& binding = each.children[k];
    if (binding.children.size() < 2) fail(binding, "an extremum needs a bounded domain");
    if (condition_of(binding)) throw Unsupported("an extremum under a 'where' condition");
    std::vector<std::string> here;
    for (const Expression& name : binding.children[0].children) {
      here.push_back(call.evaluator.bind(name.text + "~max"));
      inner.values[name.text] = {Scalar(Formula::symbol(here.back()))};
    }
    domain.factors.push_back(
        call.evaluator.continuous_set(binding.children[1], here, call.scope));
  }
  if (!is_compact(domain)) fail(each, "an extremum needs a closed, bounded domain");
  return domain;
}

Value Evaluator::resolved(const Value& value, const Expression& at) {
  const auto* extremum = value.as<Extremum>();
  if (!extremum) return value;
  const Attained place = attained(*this, *extremum, 1).front();
  Stating stating(*this);
  stating.state_attained(at, place);
  Proposition bounded =
      stating.everywhere(at, *extremum, extremum->maximum ? "<=" : ">=", Scalar(place.value),
                         {}, is_oblique(*this, *extremum));
  bounded.about = extremum->maximum ? "nowhere larger" : "nowhere smaller";
  stating.guards.push_back(std::move(bounded));
  for (auto& guard : stating.guards) sides.push_back(std::move(guard));
  return {Scalar(place.value)};
}

const Builtins& extremum_builtins() {
  static const Builtins table = {{"max", {1, -1, max}},
                                 {"min", {1, -1, min}},
                                 {"argmax", {1, 1, argmax}},
                                 {"argmin", {1, 1, argmin}}};
  return table;
}

}  // namespace seam::claims
