// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "prove/eliminate.h"
#include "prove/pseudo.h"

// The end of a case: solved equations reduce what a claimed solution says to 0, or a condition
// to something that breaks it. They are taken in the order in which they were solved: a later
// one no longer holds the variables of those before.

namespace seam::prove {

using certificate::EliminationFactor;
using certificate::EliminationStep;
using certificate::Relation;
using exact::Polynomial;
using exact::Sign;

namespace {

Relation complement(Relation relation) {
  switch (relation) {
    case Relation::positive:
      return Relation::nonpositive;
    case Relation::nonnegative:
      return Relation::negative;
    case Relation::nonpositive:
      return Relation::positive;
    case Relation::negative:
      return Relation::nonnegative;
    case Relation::zero:
      return Relation::nonzero;
    case Relation::nonzero:
      return Relation::zero;
  }
  return relation;
}

}  // namespace

Eliminator::Reduction Eliminator::reduced(const Polynomial& f, const Facts& facts) const {
  Reduction result{{}, {}, f};
  for (const Facts::Solved& solved : facts.solved) {
    const Polynomial& by = facts.equations[solved.equation];
    if (result.remainder.degree(solved.variable) < by.degree(solved.variable)) continue;
    const auto [power, quotient, remainder] =
        pseudo_divide(*stated_, result.remainder, by, solved.variable);
    const Polynomial lead = initial(by, solved.variable);
    if (power > 0) {
      result.initials.push_back({lead, power});
      for (auto& [equation, cofactor] : result.combination)
        cofactor = lead.pow(power) * cofactor;
    }
    result.combination.emplace_back(solved.equation, quotient);
    result.remainder = remainder;
  }
  return result;
}

std::vector<EliminationFactor> Eliminator::sure(const Reduction& reduction, const Facts& facts,
                                                Polynomial& multiplier) {
  std::vector<EliminationFactor> factors;
  for (const Power& lead : reduction.initials) {
    const auto [scale, powers] = factored(lead.base, *stated_);
    multiplier = multiplier * scale.pow(lead.exponent);
    for (const Power& power : powers)
      factors.push_back(
          sure(Power{power.base, power.exponent * lead.exponent}, facts, multiplier).value());
  }
  return factors;
}

bool Eliminator::is_solution(Facts& facts, std::size_t k) {
  const auto& wanted = stated_->solutions[k];
  std::vector<Reduction> reductions;
  for (const Polynomial& f : wanted) {
    reductions.push_back(reduced(f, facts));
    if (!reductions.back().remainder.is_zero()) return false;
  }
  EliminationStep solution;
  solution.kind = EliminationStep::Kind::solution;
  solution.index = static_cast<int>(k);
  for (std::size_t j = 0; j < wanted.size(); ++j) {
    const auto known = std::ranges::find(facts.equations, wanted[j]);
    solution.equations.push_back(static_cast<int>(known - facts.equations.begin()));
    if (known != facts.equations.end()) continue;
    Polynomial multiplier = wanted[j].ring().constant(1);
    auto factors = sure(reductions[j], facts, multiplier);
    factors.push_back({workshop_->write(wanted[j]), 1, -1, {}});
    step(reductions[j].combination, multiplier, std::move(factors));
    facts.equations.push_back(wanted[j]);
  }
  steps_.push_back(std::move(solution));
  return true;
}

bool Eliminator::is_outside(const Facts& facts, std::size_t condition) {
  const auto& [formula, relation] = facts.conditions[condition];
  const Reduction reduction = reduced(formula, facts);
  const Polynomial one = formula.ring().constant(1);
  if (reduction.remainder.is_zero()) {
    if (holds(relation, Sign::zero)) return false;
    Polynomial multiplier = one;
    auto factors = sure(reduction, facts, multiplier);
    factors.push_back({workshop_->write(formula), 1, static_cast<int>(condition), {}});
    step(reduction.combination, multiplier, std::move(factors));
    return true;
  }
  if (relation == Relation::nonzero) return false;
  Polynomial multiplier = one;
  for (const Power& lead : reduction.initials)
    multiplier = multiplier * lead.base.pow(lead.exponent);
  Polynomial sign = one;
  auto positive = nonvanishing_.show(multiplier, Relation::positive, facts.conditions);
  if (!positive) {
    sign = -one;
    positive = nonvanishing_.show(-multiplier, Relation::positive, facts.conditions);
  }
  if (!positive) return false;
  auto broken =
      nonvanishing_.show(sign * reduction.remainder, complement(relation), facts.conditions);
  if (!broken) return false;
  EliminationStep outside;
  outside.kind = EliminationStep::Kind::outside;
  outside.index = static_cast<int>(condition);
  outside.formula = workshop_->write(sign * multiplier);
  outside.combination = write(reduction.combination, sign);
  outside.remainder = workshop_->write(sign * reduction.remainder);
  outside.positive = std::move(*positive);
  outside.broken = std::move(*broken);
  steps_.push_back(std::move(outside));
  return true;
}

bool Eliminator::conclude(Facts& facts) {
  for (std::size_t k = 0; k < stated_->solutions.size(); ++k)
    if (is_solution(facts, k)) return true;
  for (std::size_t i = 0; i < facts.conditions.size(); ++i)
    if (is_outside(facts, i)) return true;
  if (leftover_(facts)) stopped_ = true;
  if (reason_.reason.empty())
    reason_ = {"unsupported",
               "some values of the unknowns are neither excluded nor among the solutions"};
  return false;
}

}  // namespace seam::prove
