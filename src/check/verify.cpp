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
//   condition     f is a multiple of what has a sign there.
//   factors       a product of positive numbers is positive, of numbers that are not 0 not 0.
//   squares       a sum of squares, with weights of one sign, has that sign or is 0; and 0 only
//                 where all the squares are. There the product of the conditions, a sum of
//                 multiples of what was squared, would be 0; but none of its factors is.
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

// The pieces are about factors alone; a proof on all that lies over a domain is one on it.
void verify_pieces(Context& context, const Region& whole, const Polynomial& formula,
                   Relation relation, const Pieces& pieces) {
  const Region region = without_lines(context, whole);
  demand(context.depends_only_on(formula, variables(region)),
         "pieces of a formula with a variable that has no bounds");
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

bool implies(Relation known, int scale, Relation relation) {
  for (const int sign : {-1, 0, 1})
    if (holds(known, sign) && !holds(relation, scale * sign)) return false;
  return true;
}

void verify_condition(Context& context, const Region& region, const Polynomial& formula,
                      Relation relation, const Reduction& shown) {
  const auto index = static_cast<std::size_t>(shown.conditions[0]);
  demand(index < region.where.size(), "the evidence names a condition that is none");
  const Polynomial times = context.number(shown.terms[0]);
  const Polynomial multiple = context.ring().product(times, region.where[index].formula);
  demand(context.ring().difference(multiple, formula).is_zero() &&
             implies(region.where[index].relation, context.tower().sign(times), relation),
         "the condition does not say so");
}

void verify_factors(Context& context, const Region& region, const Polynomial& formula,
                    Relation relation, const Reduction& shown) {
  const int side = direction(relation);
  demand(side != 0 || relation == Relation::nonzero, "factors do not show that a formula is 0");
  const Relation wanted = side == 0            ? Relation::nonzero
                          : holds(relation, 0) ? Relation::nonnegative
                                               : Relation::positive;
  Polynomial product = constant(side < 0 ? -1 : 1);
  for (std::size_t i = 0; i < shown.terms.size(); ++i) {
    const Polynomial factor = read_term(context, region, shown.terms[i]);
    product = context.ring().product(product, factor);
    verify(context, region, factor, wanted, shown.parts[i]);
  }
  demand(context.ring().difference(product, formula).is_zero(),
         "the formula is not the product of the factors");
}

void verify_squares(Context& context, const Region& region, Polynomial formula,
                    Relation relation, const Reduction& shown) {
  Ring& ring = context.ring();
  const bool is_strict = !shown.parts.empty();
  const std::size_t count = shown.terms.size() / (is_strict ? 3 : 2);
  int side = 0;
  Polynomial ideal = constant(1);
  for (const int condition : shown.conditions) {
    const auto index = static_cast<std::size_t>(condition);
    demand(index < region.where.size(), "the evidence names a condition that is none");
    demand(!holds(region.where[index].relation, 0), "the condition does not exclude 0");
    ideal = ring.product(ideal, region.where[index].formula);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Polynomial weight = context.number(shown.terms[i]);
    const int sign = context.tower().sign(weight);
    demand(sign != 0 && (side == 0 || sign == side), "weights of different signs");
    side = sign;
    const Polynomial q = read_term(context, region, shown.terms[count + i]);
    formula = ring.difference(std::move(formula), ring.product(weight, ring.product(q, q)));
    if (is_strict)
      ideal = ring.difference(
          std::move(ideal),
          ring.product(read_term(context, region, shown.terms[2 * count + i]), q));
  }
  demand(formula.is_zero(), "the formula is not the sum of the squares");
  if (is_strict) verify(context, region, ideal, Relation::zero, shown.parts[0]);
  demand((is_strict || holds(relation, 0)) && (side == 0 || holds(relation, side)),
         "squares do not show this relation");
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
    case Reduction::Kind::condition:
      verify_condition(context, region, formula, relation, reduction);
      return;
    case Reduction::Kind::factors:
      verify_factors(context, region, formula, relation, reduction);
      return;
    case Reduction::Kind::squares:
      verify_squares(context, region, formula, relation, reduction);
      return;
    case Reduction::Kind::combination:
      verify_combination(context, region, formula, relation, reduction);
      return;
  }
  throw Open("malformed: an unknown kind of reduction");
}

}  // namespace seam::check
