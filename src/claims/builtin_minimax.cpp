// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/builtin.h"

// minimax(E for (u,v) in triangle, a in [1, 4]): the last name is the one that is chosen.
// minimax(E, a, triangle): a is a parameter of the file, or a new name for any real number; E
// is a formula in u and v (on an interval: in u) or a function on a patch.

namespace seam::claims {
namespace {

Scalar replaced(const Scalar& value, const std::string& symbol, const std::string& by,
                Numbers& numbers) {
  return substitute(value, {{symbol, Scalar(Formula::symbol(by))}}, numbers);
}

Value over_bindings(const Call& call) {
  const Expression& each = call[0];
  if (each.kind != Expression::Kind::each || each.children.size() < 3)
    fail(each, "expected 'E for … in …, a in …': a domain, then what is chosen");
  Scope inner{&call.scope, {}};
  Extremum::Part part{0, bound_domain(call, each.children.size() - 2, inner)};
  const Expression& last = each.children.back();
  if (last.children.size() < 2 || last.children[0].children.size() != 1)
    fail(last, "expected one name and its set, 'a in [1, 2]'");
  if (condition_of(last)) throw Unsupported("'minimax' under a 'where' condition");
  const std::string& name = last.children[0].children[0].text;
  Minimax result;
  result.unknown = call.evaluator.bind(name + "~best");
  inner.values[name] = {Scalar(Formula::symbol(result.unknown))};
  result.range = call.evaluator.continuous_set(last.children[1], {result.unknown}, call.scope);
  part.value = call.evaluator.scalar(each.children[0], inner);
  result.errors = {part};
  return {result};
}

// The domain of u, v, … that a third argument names.
symbolic::Domain named_domain(const Call& call, Scope& inner) {
  static const std::vector<std::string> names = {"u", "v", "w"};
  std::vector<std::string> symbols;
  const auto bind = [&](std::size_t i) {
    symbols.push_back(call.evaluator.bind(names[i] + "~max"));
    inner.values[names[i]] = {Scalar(Formula::symbol(symbols.back()))};
    return symbols.back();
  };
  if (call.evaluator.is_interval(call[2], call.scope)) {
    const symbolic::Domain domain{
        {call.evaluator.continuous_set(call[2], {bind(0)}, call.scope)}, {}};
    if (!is_compact(domain)) fail(call[2], "an extremum needs a closed, bounded domain");
    return domain;
  }
  const auto region = call.get<Region>(2, "a domain");
  if (region.interior) fail(call[2], "an extremum needs a closed, bounded domain");
  if (region.square)
    return {{symbolic::interval(bind(0), 0, 1), symbolic::interval(bind(1), 0, 1)}, {}};
  if (region.dimension > 3) fail(call[2], "expected a domain of at most three dimensions");
  for (int i = 0; i < region.dimension; ++i) bind(i);
  return {{symbolic::standard_simplex(symbols)}, {}};
}

// The parameter of the file that the second argument names; none: the name is new, and stands
// for every real number.
const Parameter* chosen_parameter(const Call& call) {
  if (call[1].kind != Expression::Kind::name) fail(call[1], "expected the name of a variable");
  for (const Parameter& parameter : call.evaluator.parameters)
    if (parameter.name == call[1].text) return &parameter;
  if (call.evaluator.globals.contains(call[1].text))
    fail(call[1], "expected a parameter of the file or a new name, found a value");
  return nullptr;
}

Value over_parameter(const Call& call) {
  const Parameter* parameter = chosen_parameter(call);
  if (parameter && !parameter->where.empty())
    throw Unsupported("'minimax' of a parameter with a condition");
  Scope inner{&call.scope, {}};
  const std::string name = call[1].text;
  for (const Scope* s = &call.scope; s; s = s->outer)
    if (s->values.contains(name)) fail(call[1], "'" + name + "' stands for a value here");
  const symbolic::Domain domain = named_domain(call, inner);
  if (inner.values.contains(name))
    fail(call[1], "'" + name + "' is a variable of the domain", "choose another name");
  Minimax result;
  result.unknown = call.evaluator.bind(name + "~best");
  inner.values[name] = {Scalar(Formula::symbol(result.unknown))};
  const Value error = call.evaluator.evaluate(call[0], inner);
  if (const auto* field = error.as<Field>()) {
    result.errors = {part_of(*field, call[0])};
    if (result.errors[0].domain.factors.size() != domain.factors.size())
      fail(call[2], "this is not the domain of the function");
  } else {
    result.errors = {{as_scalar(call.evaluator, error, call[0]), domain}};
  }
  if (parameter && call.evaluator.hidden.contains(name))
    throw Unsupported("'minimax' of a parameter on which a sequence or a sum depends");
  // What was defined before with the parameter in it holds its symbol.
  if (parameter)
    for (Extremum::Part& part : result.errors)
      part.value = replaced(part.value, name, result.unknown, call.evaluator.numbers);
  if (parameter) result.range = parameter->set;
  if (result.range) result.range->variables = {result.unknown};
  return {result};
}

Value minimax(const Call& call) {
  if (call.count() == 2) fail(call.at, "'minimax' takes 1 or 3 arguments, found 2");
  return call.count() == 1 ? over_bindings(call) : over_parameter(call);
}

}  // namespace

const Builtins& minimax_builtins() {
  static const Builtins table = {{"minimax", {1, 3, minimax}}};
  return table;
}

}  // namespace seam::claims
