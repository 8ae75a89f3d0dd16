// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <utility>

#include "check/relation.h"
#include "check/rules.h"
#include "check/subdivision.h"

// Why each rule shows f R 0 at a point of the region.
//
//   multiplier    h > 0 there: f and h f have one sign. That f is not 0 follows from any h f.
//   conjugate     with f + h >= 0, f < 0 makes h > 0 and f h < 0; and f = 0 makes f h = 0.
//   both          a number that is >= 0 and <= 0 is 0.
//   cases         a >= 0 or a < 0 there: the point belongs to one of the two regions.
//   combination   f is the rest and the sum of the h_i e_i. With e_i = 0 that is nothing; else
//                 e_i and h_i have signs for which h_i e_i, added to a number of relation R,
//                 keeps it.
//   square        with f = s^2 c, f >= 0 where c >= 0.
//
// All terms are taken in normal form: what that changes is 0 at points of the region, where
// each function is the root of its radicand. Proofs are nested to a bounded depth: a deeper one
// has a fault.

namespace seam::check {
namespace {

using certificate::Computation;
using certificate::Pieces;
using certificate::Reduction;
using certificate::Relation;
using certificate::SignProof;
using certificate::Term;

// Of what each level of a nested proof keeps.
constexpr std::size_t most_words = Meter::max_words / 16;

Polynomial read_term(Context& context, const Region& region, Term term) {
  Polynomial result = context.value(term);
  demand(context.depends_only_on(result, variables(region)), "a variable outside the domain");
  return result;
}

// Of f where `f relation 0`, not strictly; 0 where that says nothing of it.
int direction(Relation relation) {
  const bool upward = holds(relation, 1);
  return upward == holds(relation, -1) ? 0 : upward ? 1 : -1;
}

void verify_pieces(Context& context, const Region& region, const Polynomial& formula,
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
  const Polynomial square = read_term(context, region, pieces.square);
  const Polynomial cofactor = read_term(context, region, pieces.cofactor);
  demand(
      ring.difference(ring.product(ring.product(square, square), cofactor), formula).is_zero(),
      "the formula is not the square times the cofactor");
  verify(context, region, cofactor, relation, pieces.steps);
}

void verify_cases(Context& context, const Region& region, const Polynomial& formula,
                  Relation relation, const Reduction& cases) {
  const Polynomial divider = read_term(context, region, cases.terms[0]);
  std::size_t held = words(divider);
  for (const Condition& condition : region.where) held += words(condition.formula);
  context.meter().charge(held);
  demand(held <= most_words, "effort");
  Region half = region;
  half.where.push_back({divider, Relation::nonnegative});
  verify(context, half, formula, relation, cases.parts[0]);
  half.where.back().relation = Relation::negative;
  verify(context, half, formula, relation, cases.parts[1]);
}

void verify_combination(Context& context, const Region& region, Polynomial rest,
                        Relation relation, const Reduction& combination) {
  std::size_t used = 1;
  for (std::size_t i = 0; i < combination.terms.size(); ++i) {
    const auto index = static_cast<std::size_t>(combination.conditions[i]);
    demand(index < region.where.size(), "the evidence names a condition that is none");
    const Condition& condition = region.where[index];
    const Polynomial cofactor = read_term(context, region, combination.terms[i]);
    rest = context.ring().difference(std::move(rest),
                                     context.ring().product(cofactor, condition.formula));
    if (condition.relation == Relation::zero) continue;
    const int wanted = direction(relation) * direction(condition.relation);
    demand(wanted != 0, "a condition that is no equation does not help this relation");
    demand(used < combination.parts.size(), "a cofactor lacks a proof of its sign");
    verify(context, region, cofactor,
           wanted > 0 ? Relation::nonnegative : Relation::nonpositive,
           combination.parts[used++]);
  }
  demand(used == combination.parts.size(), "not one proof for each sign that is needed");
  verify(context, region, rest, relation, combination.parts[0]);
}

}  // namespace

void verify(Context& context, const Region& region, const Polynomial& formula,
            Relation relation, const SignProof& proof) {
  context.meter().charge(1);
  if (std::holds_alternative<Computation>(proof)) {
    demand(formula.is_within(context.tower().size()) &&
               holds(relation, context.tower().sign(formula)),
           "the normal form is no number of this sign");
    return;
  }
  if (const auto* pieces = std::get_if<Pieces>(&proof)) {
    verify_pieces(context, region, formula, relation, *pieces);
    return;
  }
  const auto& reduction = std::get<Reduction>(proof);
  context.meter().charge(words(formula));
  demand(words(formula) <= most_words, "effort");
  switch (reduction.kind) {
    case Reduction::Kind::multiplier: {
      const Polynomial multiplier = read_term(context, region, reduction.terms[0]);
      if (relation != Relation::nonzero)
        verify(context, region, multiplier, Relation::positive, reduction.parts[0]);
      verify(context, region, context.ring().product(multiplier, formula), relation,
             reduction.parts[1]);
      return;
    }
    case Reduction::Kind::conjugate: {
      const int side = direction(relation);
      demand(side != 0, "a conjugate shows neither that a formula is 0 nor that it is not");
      const Polynomial conjugate = read_term(context, region, reduction.terms[0]);
      verify(context, region, context.ring().sum(conjugate, formula),
             side > 0 ? Relation::nonnegative : Relation::nonpositive, reduction.parts[0]);
      verify(context, region, context.ring().product(conjugate, formula),
             holds(relation, 0) ? Relation::nonnegative : Relation::positive,
             reduction.parts[1]);
      return;
    }
    case Reduction::Kind::both:
      demand(relation == Relation::zero, "two proofs for one relation");
      verify(context, region, formula, Relation::nonnegative, reduction.parts[0]);
      verify(context, region, formula, Relation::nonpositive, reduction.parts[1]);
      return;
    case Reduction::Kind::cases:
      verify_cases(context, region, formula, relation, reduction);
      return;
    case Reduction::Kind::combination:
      verify_combination(context, region, formula, relation, reduction);
      return;
  }
  throw Open("malformed: an unknown kind of reduction");
}

}  // namespace seam::check
