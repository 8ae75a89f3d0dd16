// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/state.h"

#include <algorithm>

#include "claims/any_mesh.h"
#include "claims/induction.h"
#include "claims/parameters.h"

// Outside every quantifier a statement is true or false, and `or`, `not`, `implies` are what
// they are for propositions. Under "for all" they are moved inwards to the relations:
// for all x (A or B) is the same as: for all x where not A, B.

namespace seam::claims {
using Kind = Expression::Kind;

Proposition Stating::state(const Expression& e, const Scope& scope, const Context& context,
                           bool positive) {
  const auto part = [&](std::size_t i, bool sign) {
    return state(e.children[i], scope, context, sign);
  };
  switch (e.kind) {
    case Kind::negation:
      return part(0, !positive);
    case Kind::conjunction:
      if (positive) return symbolic::all({part(0, true), part(1, true)});
      return alternatives({{&e.children[0], false}, {&e.children[1], false}}, scope, context);
    case Kind::disjunction:
      if (!positive) return symbolic::all({part(0, false), part(1, false)});
      return alternatives({{&e.children[0], true}, {&e.children[1], true}}, scope, context);
    case Kind::implication:
      if (!positive) return symbolic::all({part(0, true), part(1, false)});
      return alternatives({{&e.children[0], false}, {&e.children[1], true}}, scope, context);
    case Kind::equivalence: {
      if (!positive) {
        if (!context.empty())
          throw Unsupported("'not (… iff …)' under 'for all' is not covered");
        return symbolic::negation(state(e, scope, context));
      }
      return symbolic::all(
          {alternatives({{&e.children[0], false}, {&e.children[1], true}}, scope, context),
           alternatives({{&e.children[0], true}, {&e.children[1], false}}, scope, context)});
    }
    case Kind::for_all:
    case Kind::for_some:
      return quantified(e, scope, context, positive);
    case Kind::relation:
    case Kind::truncated:
      return relation(e, scope, context, positive);
    case Kind::solve: {
      if (!context.empty() && !positive)
        throw Unsupported("'not solve' for all parameters is not covered");
      Proposition p = solved(e, scope, context);
      return positive ? p : symbolic::negation(std::move(p));
    }
    case Kind::call:
    case Kind::name:
      return called(e, scope, context, positive);
    default:
      fail(e, "expected a statement, found a value",
           "a claim compares, quantifies or uses a predicate");
  }
}

// One of the parts holds, at every point of the context.
Proposition Stating::alternatives(const std::vector<std::pair<const Expression*, bool>>& parts,
                                  const Scope& scope, const Context& context) {
  if (context.empty()) {
    std::vector<Proposition> all;
    for (const auto& [part, positive] : parts) {
      Proposition p = state(*part, scope, context);
      all.push_back(positive ? std::move(p) : symbolic::negation(std::move(p)));
    }
    return symbolic::any(std::move(all));
  }
  // What is said rather than denied is kept as it stands; the others become its conditions.
  std::vector<std::size_t> order;
  for (const bool sign : {true, false})
    for (std::size_t i = parts.size(); i-- > 0;)
      if (parts[i].second == sign) order.push_back(i);
  for (const std::size_t last : order) {
    Context narrowed = context;
    bool convertible = true;
    for (std::size_t i = 0; i < parts.size() && convertible; ++i)
      if (i != last) convertible = assume(*parts[i].first, scope, narrowed, !parts[i].second);
    if (!convertible) continue;
    if (auto broken = take_numbers(narrowed)) return *broken;
    return state(*parts[last].first, scope, narrowed, parts[last].second);
  }
  throw Unsupported("this 'or' under 'for all' is not covered: no side is a plain comparison");
}

// The parameters of the file that occur in any formula.
static void collect(const Proposition& p, std::set<std::string>& found) {
  for (const Proposition& part : p.parts) collect(part, found);
  if (p.kind != Proposition::Kind::atom) return;
  const auto add = [&](const Formula& f) { found.merge(symbolic::variables(f)); };
  if (const auto* zero = std::get_if<symbolic::Zero>(&p.atom)) add(zero->formula);
  if (const auto* distinct = std::get_if<symbolic::Distinct>(&p.atom))
    for (const auto& tuple : distinct->tuples) std::ranges::for_each(tuple, add);
  if (const auto* sign = std::get_if<symbolic::Sign>(&p.atom)) {
    add(sign->formula);
    for (const auto& constraint : sign->domain.where) add(constraint.formula);
  }
  if (const auto* only = std::get_if<symbolic::OnlySolutions>(&p.atom)) {
    std::ranges::for_each(only->system, add);
    for (const auto& constraint : only->domain.where) add(constraint.formula);
    for (const auto& solution : only->solutions)
      for (const auto& [numerator, denominator] : solution) {
        add(numerator);
        add(denominator);
      }
  }
}

std::set<std::string> variables_of(const Proposition& p) {
  std::set<std::string> found;
  collect(p, found);
  return found;
}

static Context parameters_in(const Evaluator& evaluator, const Stating& stating,
                             const Proposition& goal) {
  std::set<std::string> found;
  collect(goal, found);
  for (const Proposition& guard : stating.guards) collect(guard, found);
  for (const Proposition& side : evaluator.sides) collect(side, found);
  Context context;
  context.functions = stating.speaks_of_functions;
  join_parameters(evaluator, found, context);
  return context;
}

// A statement that holds a parameter is one about all its values: "for all" stands around it,
// unsaid. Whether one does shows when it has been stated once.
Stated stated_under(Evaluator& evaluator, const Expression& statement, const Scope& scope,
                    const std::vector<symbolic::Constraint>& known) {
  Context context;
  for (;;) {
    Stating stating(evaluator);
    evaluator.sides = evaluator.standing;
    Stated result;
    result.goal = stating.state(statement, scope, context);
    if (context.empty()) {
      context = parameters_in(evaluator, stating, result.goal);
      context.where.insert(context.where.end(), known.begin(), known.end());
      if (!context.empty()) continue;
    }
    result.goal = of_meshes(evaluator, std::move(result.goal));
    std::vector<Proposition> sides;
    for (const Proposition& side : evaluator.sides)
      sides.push_back(stating.settled(side, context, statement));
    result.guards = std::move(stating.guards);
    result.guards.insert(result.guards.end(), sides.begin(), sides.end());
    result.predicates = std::move(stating.predicates);
    evaluator.sides.clear();
    return result;
  }
}

// That it holds an integer parameter shows when its value is wanted.
Stated state(Evaluator& evaluator, const Expression& statement, const Scope& scope) {
  const std::set<std::string> bound = evaluator.bound_symbols();
  std::string met;
  try {
    return stated_under(evaluator, statement, scope, {});
  } catch (const IntegerMet& integer) {
    met = integer.parameter;
  }
  evaluator.bind_only(bound);
  try {
    return for_every_integer(evaluator, statement, scope, met);
  } catch (const IntegerMet& integer) {
    met = integer.parameter;  // the condition of the first holds it
  }
  evaluator.bind_only(bound);
  return for_every_integer(evaluator, statement, scope, met);
}

}  // namespace seam::claims
