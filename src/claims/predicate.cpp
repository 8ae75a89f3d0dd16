// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "claims/builtin.h"
#include "claims/predicate_table.h"
#include "claims/stating.h"
#include "symbolic/coefficients.h"

// Predicates of the language by name, and statements that a file defines.

namespace seam::claims {
namespace {

using geometry::Criterion;
using geometry::Curve;
using geometry::Patch;

// The variables of an atom that it does not range over itself.
std::set<std::string> open_variables(const Proposition& atom) {
  std::set<std::string> open;
  if (const auto* zero = std::get_if<symbolic::Zero>(&atom.atom))
    open = symbolic::variables(zero->formula);
  if (const auto* sign = std::get_if<symbolic::Sign>(&atom.atom)) {
    open = symbolic::variables(sign->formula);
    for (const auto& factor : sign->domain.factors)
      for (const std::string& v : factor.variables) open.erase(v);
  }
  open.erase(geometry::parameter_u);
  open.erase(geometry::parameter_v);
  return open;
}

bool is_bounded(const Value& value) {
  const auto* curve = value.as<CurveField>();
  return value.as<Patch>() || value.as<Field>() || value.as<Curve>() ||
         (curve && curve->is_segment);
}

bool mentions_variables(const Proposition& p) {
  if (p.kind == Proposition::Kind::atom) return !open_variables(p).empty();
  return std::ranges::any_of(p.parts, mentions_variables);
}

bool is_plain_conjunction(const Proposition& p) {
  if (p.kind == Proposition::Kind::atom) return true;
  return p.kind == Proposition::Kind::all && std::ranges::all_of(p.parts, is_plain_conjunction);
}

// Identities, and conjunctions of them. If none of several holds for all values of the
// variables, there are values for which none does: a product of polynomials that are not 0 is
// not. (A product of roots may be.)
bool are_identities(const std::vector<Proposition>& parts) {
  return std::ranges::all_of(parts, [](const Proposition& part) {
    if (part.kind == Proposition::Kind::all) return are_identities(part.parts);
    return part.kind == Proposition::Kind::atom &&
           std::holds_alternative<symbolic::Zero>(part.atom) &&
           geometry::is_rational_function(std::get<symbolic::Zero>(part.atom).formula);
  });
}

// A quotient vanishes where its numerator does.
geometry::Search searching(const Context& context, Evaluator& evaluator) {
  const auto vanishes = [&numbers = evaluator.numbers](const Formula& f) {
    return symbolic::vanishes(scalar_of(f, numbers).numerator, numbers);
  };
  geometry::Search search{evaluator.numbers, vanishes, {}};
  for (const long weight : {1, 3, 8})
    search.samples.push_back(sample(context, evaluator, weight));
  return search;
}

// What has to hold where its failure would not refute the predicate: then the claim is
// undecided.
void collect_guards(const Proposition& p, Criterion::Failure failure,
                    std::vector<Proposition>& guards) {
  if (failure == Criterion::Failure::refutes) return;
  for (const Proposition& part : p.parts) collect_guards(part, failure, guards);
  if (p.kind == Proposition::Kind::atom && (failure == Criterion::Failure::says_nothing ||
                                            !std::holds_alternative<symbolic::Zero>(p.atom)))
    guards.push_back(p);
}

}  // namespace

std::vector<std::string> predicate_names() {
  std::vector<std::string> names = {"partition_of_unity", "nonnegative"};
  for (const auto& predicate : predicate_table()) names.push_back(predicate.first);
  return names;
}

// Not of one member of a family of patches, but of all together. A polynomial that is not
// identically 0 is not 0 all over an open set, which strict conditions leave, if anything.
// Under other conditions, or of other functions, it is asked that they are nowhere all 0.
Proposition Stating::some_nonzero(const std::vector<Formula>& formulas, const Context& context,
                                  const Expression& at) {
  Context all = context;
  all.where.clear();
  all.given.clear();
  std::vector<symbolic::Constraint> conditions = context.where;
  for (const Assumption& assumption : context.given)
    conditions.insert(conditions.end(), assumption.constraints.begin(),
                      assumption.constraints.end());
  const bool are_strict = std::ranges::all_of(conditions, [](const auto& c) {
    return c.relation == Relation::positive || c.relation == Relation::negative ||
           c.relation == Relation::nonzero;
  });
  bool is_enough = are_strict;
  Formula sum_of_squares = 0;
  std::vector<Proposition> zeros;
  for (const Formula& f : formulas) {
    const Independent free = independent(f, all);
    if (!free.is_exact)
      throw Unsupported("a patch on which one function has several arguments");
    is_enough = is_enough && free.formula.is_polynomial();
    sum_of_squares += symbolic::power(f, 2);
    zeros.push_back(symbolic::atom(symbolic::Zero{f}));
  }
  if (!conditions.empty() && !is_enough) {
    guards.push_back(settled(
        symbolic::atom(symbolic::Sign{sum_of_squares, Relation::positive, {}}, "nowhere 0"),
        context, at));
    return symbolic::truth();
  }
  return symbolic::negation(settled(symbolic::all(std::move(zeros)), all, at),
                            "not identically 0");
}

Proposition Stating::called(const Expression& e, const Scope& scope, const Context& context,
                            bool positive) {
  const bool bare = e.kind == Expression::Kind::name;
  const Expression& callee = bare ? e : e.children[0];
  const std::size_t given = bare ? 0 : e.children.size() - 1;
  if (callee.kind != Expression::Kind::name) fail(e, "expected a statement, found a value");
  const std::string& name = callee.text;

  if (const auto found = evaluator.globals.find(name); found != evaluator.globals.end()) {
    const Definition& definition = found->second;
    if (definition.broken) throw Broken();
    if (!definition.item || definition.item->kind != Item::Kind::define)
      fail(e, "expected a statement, found the value '" + name + "'");
    const Item& item = *definition.item;
    if (item.parameters.size() != given)
      fail(e, "'" + name + "' takes " + std::to_string(item.parameters.size()) +
                  " arguments, found " + std::to_string(given));
    Scope inner;
    for (std::size_t i = 0; i < given; ++i)
      inner.values[item.parameters[i]] = evaluator.evaluate(e.children[i + 1], scope);
    return state(item.expressions[0], inner, context, positive);
  }

  if (!bare && is_about_functions(e)) {
    if (!positive && !context.empty())
      throw Unsupported("this predicate negated for all values of a parameter");
    Proposition p = about_functions(e, scope, context);
    return positive ? p : symbolic::negation(std::move(p));
  }

  const auto entry = predicate_table().find(name);
  if (entry == predicate_table().end()) {
    std::vector<std::string> known = predicate_names();
    for (const auto& global : evaluator.globals) known.push_back(global.first);
    const std::vector<std::string> functions = builtin_names();
    if (std::ranges::find(functions, name) != functions.end())
      fail(e, "expected a statement, found a value of '" + name + "'");
    const std::string near = text::nearest(name, known);
    fail(callee, "unknown predicate '" + name + "'",
         near.empty() ? "" : "did you mean '" + near + "'?");
  }
  Arguments arguments{evaluator, e, searching(context, evaluator), {}};
  if (static_cast<int>(given) < entry->second.least ||
      static_cast<int>(given) > entry->second.most)
    fail(e, "'" + name + "' takes " + std::to_string(entry->second.least) +
                (entry->second.most > entry->second.least
                     ? " or " + std::to_string(entry->second.most)
                     : "") +
                (entry->second.most == 1 ? " argument" : " arguments") + ", found " +
                std::to_string(given));
  for (std::size_t i = 0; i < given; ++i) {
    const Expression& argument = e.children[i + 1];
    const bool is_named = argument.kind == Expression::Kind::named;
    arguments.values.push_back(
        evaluator.evaluate(is_named ? argument.children[0] : argument, scope));
  }
  predicates.insert(name);
  auto [p, failure, nonzero] = entry->second.state(arguments);
  // A function with what is assumed near one point need not go on like this over a whole patch.
  if (!context.given.empty() && std::ranges::any_of(arguments.values, is_bounded))
    failure = Criterion::Failure::says_nothing;
  const bool open = mentions_variables(p) || !context.is_unconditional();
  const bool refuted_for_all = p.kind == Proposition::Kind::any && are_identities(p.parts) &&
                               failure == Criterion::Failure::refutes &&
                               context.is_unconditional();
  if (open && (!positive || (!is_plain_conjunction(p) && !refuted_for_all)))
    throw Unsupported(
        "this predicate for all values of a parameter: it is negated, or not along one pair of "
        "sides that is one curve for all of them");
  std::vector<Proposition> necessary;
  collect_guards(p, failure, necessary);
  for (Proposition& guard : necessary) guards.push_back(settled(std::move(guard), context, e));
  p = settled(std::move(p), context, e);
  if (!nonzero.empty()) p = symbolic::all({std::move(p), some_nonzero(nonzero, context, e)});
  return positive ? p : symbolic::negation(std::move(p));
}

}  // namespace seam::claims
