// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "claims/stating.h"

// A predicate speaks of the points of its patches; their control points may be quotients and
// roots of functions of parameters. Each of its statements becomes one for all values of these:
// an identity of polynomials after the denominators are cleared, an inequality over the product
// of both domains.

namespace seam::claims {
namespace {

bool is_bound(const std::string& variable, const Context& context) {
  return std::ranges::find(context.lines, variable) != context.lines.end() ||
         std::ranges::any_of(context.factors, [&](const symbolic::Simplex& factor) {
           return std::ranges::find(factor.variables, variable) != factor.variables.end();
         });
}

// The context, and every real value for each other variable of the formula.
Context for_all_variables(const Formula& f, Context context,
                          const std::vector<Parameter>& parameters) {
  for (const std::string& variable : symbolic::variables(f)) {
    const bool is_parameter =
        std::ranges::any_of(parameters, [&](const Parameter& p) { return p.name == variable; });
    if (!is_parameter && !is_bound(variable, context)) context.lines.push_back(variable);
  }
  return context;
}

// Without quotients and roots, and with no variables but those of its domain.
bool is_settled(const symbolic::Sign& sign) {
  Context own;
  own.factors = sign.domain.factors;
  const auto is_plain = [&](const Formula& f) {
    return f.is_polynomial() && std::ranges::all_of(symbolic::variables(f), [&](const auto& v) {
             return is_bound(v, own);
           });
  };
  return is_plain(sign.formula) &&
         std::ranges::all_of(sign.domain.where, [&](const auto& constraint) {
           return is_plain(constraint.formula);
         });
}

}  // namespace

Proposition Stating::settled(Proposition p, const Context& context, const Expression& at) {
  for (Proposition& part : p.parts) part = settled(std::move(part), context, at);
  if (p.kind != Proposition::Kind::atom) return p;
  if (const auto* zero = std::get_if<symbolic::Zero>(&p.atom)) {
    if (zero->formula.is_polynomial() && context.is_unconditional()) return p;
    const Scalar value = scalar_of(zero->formula, evaluator.numbers);
    const Context all = for_all_variables(zero->formula, context, evaluator.parameters);
    const symbolic::Constraint c = related(value, Relation::zero, all, at);
    return holds(c.formula, c.relation, all, at, p.about);
  }
  if (const auto* sign = std::get_if<symbolic::Sign>(&p.atom)) {
    if (context.is_unconditional() && is_settled(*sign)) return p;
    Context all = context;
    all.factors.insert(all.factors.end(), sign->domain.factors.begin(),
                       sign->domain.factors.end());
    all = for_all_variables(sign->formula, std::move(all), evaluator.parameters);
    for (const symbolic::Constraint& constraint : sign->domain.where)
      all.where.push_back(related(scalar_of(constraint.formula, evaluator.numbers),
                                  constraint.relation, all, at));
    const symbolic::Constraint c =
        related(scalar_of(sign->formula, evaluator.numbers), sign->relation, all, at);
    return holds(c.formula, c.relation, all, at, p.about);
  }
  if (!context.is_unconditional()) throw Unsupported("this predicate under a condition");
  if (const auto* distinct = std::get_if<symbolic::Distinct>(&p.atom))
    for (const symbolic::Point& tuple : distinct->tuples)
      if (!std::ranges::all_of(tuple, &Formula::is_polynomial))
        throw Unsupported("counting things whose coordinates are functions");
  return p;
}

}  // namespace seam::claims
