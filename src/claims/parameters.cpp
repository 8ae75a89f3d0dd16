// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/parameters.h"

#include <algorithm>

// What is said of a parameter is said where its condition holds; so the condition goes wherever
// the parameter goes.

namespace seam::claims {
namespace {

using symbolic::Constraint;

constexpr long most_points = 20'000;

std::set<std::string> bound_in(const Context& context) {
  std::set<std::string> bound(context.lines.begin(), context.lines.end());
  for (const symbolic::Simplex& factor : context.factors)
    bound.insert(factor.variables.begin(), factor.variables.end());
  return bound;
}

bool contains(const std::vector<Constraint>& all, const Constraint& one) {
  return std::ranges::any_of(all, [&](const Constraint& c) {
    return c.relation == one.relation && c.formula.same(one.formula);
  });
}

// Values to try for a parameter.
std::vector<Formula> trials(const Parameter& parameter, Evaluator& evaluator) {
  std::vector<Formula> result;
  if (!parameter.set) {
    for (const char* value : {"0", "1", "2", "-1", "1/2", "3", "-2", "10", "-10", "1/10"})
      result.emplace_back(exact::Rational(value));
    return result;
  }
  const auto& corners = parameter.set->corners;
  for (const char* share : {"1", "1/3", "3", "1/20", "20"}) {
    const Formula other{exact::Rational(share)};
    const Formula inverse = evaluator.numbers.inverse(corners[0][0] + other * corners[1][0]);
    result.push_back(
        evaluator.numbers.normal_form((corners[0][1] + other * corners[1][1]) * inverse));
  }
  return result;
}

}  // namespace

bool meets(exact::Sign sign, Relation relation) {
  const bool positive = sign == exact::Sign::positive, zero = sign == exact::Sign::zero;
  switch (relation) {
    case Relation::positive:
      return positive;
    case Relation::nonnegative:
      return positive || zero;
    case Relation::zero:
      return zero;
    case Relation::nonzero:
      return !zero;
    case Relation::nonpositive:
      return !positive;
    case Relation::negative:
      return !positive && !zero;
  }
  return false;
}

void join_parameters(const Evaluator& evaluator, std::set<std::string>& variables,
                     Context& context) {
  const std::set<std::string> bound = bound_in(context);
  std::set<std::string> joined;
  for (bool more = true; more;) {
    more = false;
    for (const Parameter& parameter : evaluator.parameters) {
      if (!variables.contains(parameter.name) || !joined.insert(parameter.name).second)
        continue;
      more = true;
      for (const Constraint& condition : parameter.where) {
        if (!contains(context.where, condition)) context.where.push_back(condition);
        variables.merge(symbolic::variables(condition.formula));
      }
    }
  }
  for (const Parameter& parameter : evaluator.parameters) {
    if (!joined.contains(parameter.name) || bound.contains(parameter.name)) continue;
    if (parameter.set)
      context.factors.push_back(*parameter.set);
    else
      context.lines.push_back(parameter.name);
  }
}

bool is_inhabited(Evaluator& evaluator, const std::set<std::string>& parameters) {
  std::set<std::string> variables = parameters;
  Context context;
  join_parameters(evaluator, variables, context);
  std::vector<std::pair<std::string, std::vector<Formula>>> choices;
  for (const Parameter& parameter : evaluator.parameters)
    if (variables.contains(parameter.name))
      choices.emplace_back(parameter.name, trials(parameter, evaluator));
  for (long number = 0; number < most_points; ++number) {
    std::map<std::string, Formula> point;
    long rest = number;
    for (const auto& [name, values] : choices) {
      point.emplace(name, values[rest % std::ssize(values)]);
      rest /= std::ssize(values);
    }
    if (rest > 0) return false;
    const bool met = std::ranges::all_of(context.where, [&](const Constraint& c) {
      if (!c.formula.is_polynomial()) return false;
      return meets(evaluator.numbers.sign(symbolic::subst(c.formula, point)), c.relation);
    });
    if (met) return true;
  }
  return false;
}

}  // namespace seam::claims
