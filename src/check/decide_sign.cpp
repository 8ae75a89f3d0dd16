// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "check/point.h"
#include "check/relation.h"
#include "check/rules.h"
#include "check/subdivision.h"

// Why a change of sign refutes `nonzero`: a product of simplices, less some facets, is
// convex, so the segment between the two points lies in it, and a polynomial on
// it that takes both signs takes 0.

namespace seam::check {
namespace {

using certificate::Computation;
using certificate::Pieces;
using certificate::Relation;
using certificate::Sign;
using certificate::Witness;

// Without a factor the domain is one point, or none where a condition is broken.
bool compute(Context& context, const Region& region, const Polynomial& formula,
             Relation relation) {
  if (formula.is_zero() && holds(relation, 0)) return true;
  demand(formula.is_within(context.tower().size()),
         "computing does not decide a sign that depends on variables");
  if (holds(relation, context.tower().sign(formula))) return true;
  demand_inside(context, region, {});
  return false;
}

bool refutes(Context& context, const Region& region, const Polynomial& formula,
             Relation relation, const Witness& witness) {
  const auto sign_at = [&](const certificate::Point& named) {
    const Point point = read_point(context, named);
    demand_inside(context, region, point);
    return context.tower().sign(value_at(context, formula, point));
  };
  const int sign = sign_at(witness.point);
  if (!holds(relation, sign)) return true;
  return relation == Relation::nonzero && !witness.other.empty() && region.where.empty() &&
         sign_at(witness.other.front()) * sign < 0;
}

}  // namespace

void verify(Context& context, const Region& region, const Polynomial& formula,
            Relation relation, const Pieces& pieces) {
  if (pieces.square < 0) {
    const bool is_nonzero = relation == Relation::nonzero;
    demand(
        !is_nonzero || pieces.side == Relation::positive || pieces.side == Relation::negative,
        "evidence for a value other than 0 names no strict sign");
    verify(context, region, formula, is_nonzero ? pieces.side : relation, pieces.steps);
    return;
  }
  demand(relation == Relation::nonnegative || relation == Relation::nonpositive,
         "a square may be 0: it shows no strict sign");
  Ring& ring = context.ring();
  const Polynomial square = context.value(pieces.square);
  const Polynomial cofactor = context.value(pieces.cofactor);
  demand(context.depends_only_on(square, variables(region)) &&
             context.depends_only_on(cofactor, variables(region)),
         "a variable outside the domain");
  demand(
      ring.difference(ring.product(ring.product(square, square), cofactor), formula).is_zero(),
      "the formula is not the square times the cofactor");
  verify(context, region, cofactor, relation, pieces.steps);
}

bool decide(Context& context, const Sign& obligation, const certificate::Proof& proof) {
  const Region region = make_region(context, obligation.domain);
  const Polynomial formula = context.value(obligation.formula);
  demand(context.depends_only_on(formula, variables(region)),
         "degenerate: a variable outside the domain");
  if (std::holds_alternative<Computation>(proof))
    return compute(context, region, formula, obligation.relation);
  if (const auto* pieces = std::get_if<Pieces>(&proof)) {
    verify(context, region, formula, obligation.relation, *pieces);
    return true;
  }
  const auto* witness = std::get_if<Witness>(&proof);
  demand(witness != nullptr, "evidence of a kind that says nothing of a sign");
  demand(refutes(context, region, formula, obligation.relation, *witness),
         "the relation holds at the witness");
  return false;
}

}  // namespace seam::check
