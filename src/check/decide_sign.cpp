// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "check/point.h"
#include "check/relation.h"
#include "check/rules.h"

// Where a function has no value, an obligation that holds it says nothing: the points in
// question are those of the domain with, for each function, the root of its radicand as one
// coordinate more. Which functions: those that the terms hold as written, not those left in
// normal form.
//
// A variable that belongs to no factor is a line of the domain: it takes every real value.
//
// Why a change of sign refutes `nonzero`: a product of simplices, less some facets, is
// convex, so the segment between the two points lies in it, and a polynomial on
// it that takes both signs takes 0.

namespace seam::check {
namespace {

using certificate::Computation;
using certificate::Relation;
using certificate::Sign;
using certificate::Term;
using certificate::Witness;

// What an obligation is about.
struct Stated {
  std::set<int> functions;
  Region domain;
  Polynomial formula;
  Relation relation;
};

Stated read(Context& context, const Sign& sign) {
  std::vector<Term> terms = {sign.formula};
  for (const auto& condition : sign.domain.where) terms.push_back(condition.formula);
  Stated stated{context.functions(terms), {}, context.value(sign.formula), sign.relation};
  std::set<int> free = context.variables(stated.formula);
  for (const Term term : terms) free.merge(context.variables(context.value(term)));
  for (const int function : stated.functions)
    free.merge(context.variables(context.operand(function)));
  for (const int function : stated.functions) free.erase(function);
  for (const auto& factor : sign.domain.factors)
    for (const std::string& name : factor.variables) free.erase(context.variable(name));
  std::set<int> others = stated.functions;
  others.insert(free.begin(), free.end());
  stated.domain = make_region(context, sign.domain, others);
  stated.domain.lines = std::move(free);
  return stated;
}

// Without a factor the domain is one point, or none where a condition is broken.
bool compute(Context& context, const Stated& stated) {
  if (stated.formula.is_zero() && holds(stated.relation, 0)) return true;
  demand(stated.formula.is_within(context.tower().size()),
         "computing does not decide a sign that depends on variables");
  if (holds(stated.relation, context.tower().sign(stated.formula))) return true;
  demand_inside(context, stated.domain, stated.functions, {});
  return false;
}

bool refutes(Context& context, const Stated& stated, const Witness& witness) {
  const auto sign_at = [&](const certificate::Point& named) {
    const Point point = read_point(context, named);
    demand_inside(context, stated.domain, stated.functions, point);
    return context.tower().sign(value_at(context, stated.formula, point));
  };
  const int sign = sign_at(witness.point);
  if (!holds(stated.relation, sign)) return true;
  return stated.relation == Relation::nonzero && !witness.other.empty() &&
         stated.domain.where.empty() && stated.functions.empty() &&
         sign_at(witness.other.front()) * sign < 0;
}

}  // namespace

bool decide(Context& context, const Sign& obligation, const certificate::Proof& proof) {
  const Stated stated = read(context, obligation);
  std::set<int> held = variables(stated.domain);
  held.insert(stated.functions.begin(), stated.functions.end());
  bool is_inside = context.depends_only_on(stated.formula, held);
  for (const int function : stated.functions)
    is_inside = is_inside && context.depends_only_on(context.operand(function), held);
  demand(is_inside, "degenerate: a variable outside the domain");
  const auto by = [&](const certificate::SignProof& shown) {
    const Region region = with_functions(context, stated.domain, stated.functions);
    demand(context.depends_only_on(stated.formula, variables(region)),
           "a logarithm has no coordinate");
    verify(context, region, stated.formula, stated.relation, shown);
    return true;
  };
  if (std::holds_alternative<Computation>(proof)) return compute(context, stated);
  if (const auto* pieces = std::get_if<certificate::Pieces>(&proof)) return by(*pieces);
  if (const auto* reduction = std::get_if<certificate::Reduction>(&proof))
    return by(*reduction);
  const auto* witness = std::get_if<Witness>(&proof);
  demand(witness != nullptr, "evidence of a kind that says nothing of a sign");
  demand(refutes(context, stated, *witness), "the relation holds at the witness");
  return false;
}

}  // namespace seam::check
