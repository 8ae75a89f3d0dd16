// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/eliminate.h"

#include <algorithm>
#include <array>

#include "exact/field.h"
#include "prove/pseudo.h"

// Ritt's method, with the steps written down as they are taken. An equation whose initial in a
// variable vanishes nowhere reduces all others to lower degrees in that variable; when it is
// the only one left that holds the variable, it is solved. Before that, products are taken
// apart, and an initial that may vanish makes two cases. What comes of each step is freed of
// factors that vanish nowhere.
//
// Ends because steps are counted, and a step of the search writes down one of the evidence.

namespace seam::prove {

using certificate::EliminationFactor;
using certificate::EliminationStep;
using certificate::Relation;
using exact::Polynomial;

namespace {

constexpr long most_steps = 4000;
constexpr std::size_t most_known = 1500;  // that the checker follows
constexpr std::size_t most_terms = 20'000;

bool excludes_zero(Relation relation) {
  return !holds(relation, exact::Sign::zero);
}

// A number s with a = s * b, or 0.
Polynomial ratio(const Polynomial& a, const Polynomial& b) {
  const auto lead = [](const Polynomial& f) {
    const auto numerators = f.numerators();
    return f.ring().number(numerators.terms.rbegin()->second, numerators.denominator);
  };
  const Polynomial s = lead(a) * exact::inverse(lead(b));
  return s * b == a ? s : a.ring().constant(0);
}

Polynomial multiplied(const Polynomial& one, const std::vector<Power>& powers) {
  Polynomial product = one;
  for (const Power& power : powers) product = product * power.base.pow(power.exponent);
  return product;
}

}  // namespace

Eliminator::Eliminator(Workshop& workshop, const Equations& stated, Leftover leftover)
    : workshop_(&workshop),
      stated_(&stated),
      leftover_(std::move(leftover)),
      nonvanishing_(workshop, stated) {}

std::optional<certificate::Elimination> Eliminator::run() {
  Facts facts{stated_->system, stated_->conditions, {}, {}};
  // Where a condition excludes 0, it does so for each of its factors.
  for (std::size_t i = 0; i < stated_->conditions.size(); ++i) {
    const auto& [formula, relation] = stated_->conditions[i];
    if (!excludes_zero(relation) || formula.is_zero() || formula.is_number()) continue;
    const Product product = factored(formula, *stated_);
    if (product.powers.size() == 1 && product.powers[0].exponent == 1) continue;
    if (!product.multiplier.is_number()) continue;
    for (const Power& power : product.powers) {
      EliminationStep cases;
      cases.kind = EliminationStep::Kind::cases;
      cases.formula = workshop_->write(power.base);
      steps_.push_back(std::move(cases));
      std::vector<Power> others = product.powers;
      for (Power& other : others)
        if (other.base == power.base) --other.exponent;
      EliminationFactor excluded{workshop_->write(formula), 1, static_cast<int>(i), {}};
      step({{static_cast<int>(facts.equations.size()),
             multiplied(exact::inverse(product.multiplier), others)}},
           formula.ring().constant(1), {std::move(excluded)});
      facts.conditions.push_back({power.base, Relation::nonzero});
    }
  }
  for (int i = 0; i < std::ssize(stated_->system); ++i)
    facts.open.push_back(
        {i, {stated_->system[static_cast<std::size_t>(i)].ring().constant(1), {}}});
  const Outcome begun = refresh(facts);
  const bool closed =
      begun == Outcome::closed || (begun == Outcome::goes_on && solve(std::move(facts)));
  if (!closed) return std::nullopt;
  return certificate::Elimination{std::move(steps_)};
}

bool Eliminator::give_up(std::string reason, std::string detail) {
  if (reason_.reason.empty()) reason_ = {std::move(reason), std::move(detail)};
  stopped_ = true;
  return false;
}

bool Eliminator::solve(Facts facts) {
  for (;;) {
    if (stopped_) return false;
    if (workshop_->late()) return give_up("time", "the time given was over");
    if (++taken_ > std::min(most_steps, workshop_->budget().effort) ||
        facts.equations.size() + facts.conditions.size() > most_known)
      return give_up("effort", "undecided after " + std::to_string(taken_) + " eliminations");
    if (const auto linear = choose(facts, true)) {
      const Outcome outcome = reduce(facts, *linear);
      if (outcome != Outcome::goes_on) return outcome == Outcome::closed;
      continue;
    }
    std::optional<std::size_t> product;
    for (std::size_t i = 0; i < facts.open.size(); ++i)
      if (const std::size_t n = facts.open[i].product.powers.size();
          n > 1 && (!product || n < facts.open[*product].product.powers.size()))
        product = i;
    if (product) return branch(facts, *product);
    if (facts.open.empty()) return conclude(facts);
    const auto pivot = choose(facts, false);
    if (!pivot)
      return give_up("unsupported",
                     "an equation between parameters that may hold for some of their values");
    const Facts::Open& open = facts.open[pivot->place];
    if (!pivot->is_sure)
      return distinguish(facts, initial(facts.equations[open.equation], pivot->variable));
    const Outcome outcome = reduce(facts, *pivot);
    if (outcome != Outcome::goes_on) return outcome == Outcome::closed;
  }
}

// The equation and the variable of lowest degree: sure initials before others, short equations
// before long ones. Products are left alone; a parameter is solved for only where no unknown is
// left, for what is known of its domain would be lost.
std::optional<Eliminator::Pivot> Eliminator::choose(const Facts& facts, bool linear) {
  struct Candidate {
    std::array<long, 2> rank;
    Pivot pivot;
  };
  std::vector<Candidate> candidates;
  for (std::size_t i = 0; i < facts.open.size(); ++i) {
    if (facts.open[i].product.powers.size() != 1) continue;
    const Polynomial& f = facts.equations[facts.open[i].equation];
    const auto terms = static_cast<long>(f.numerators().terms.size());
    for (int v = 0; v < std::ssize(f.ring().variables()); ++v) {
      const int degree = f.degree(v);
      if (degree < 1 || (linear && degree > 1)) continue;
      const bool is_unknown = std::ranges::count(stated_->unknowns, v) > 0;
      if (is_unknown || (f.degree(stated_->unknowns) < 1 && !stated_->holds_function(f)))
        candidates.push_back({{degree, terms}, {i, v, degree, false}});
    }
  }
  std::ranges::stable_sort(candidates, {}, &Candidate::rank);
  for (Candidate& candidate : candidates) {
    Pivot& pivot = candidate.pivot;
    if (!linear && pivot.degree > candidates.front().pivot.degree) break;
    const Polynomial& f = facts.equations[facts.open[pivot.place].equation];
    pivot.is_sure = vanishes_nowhere(initial(f, pivot.variable), facts);
    if (pivot.is_sure) return pivot;
  }
  if (linear || candidates.empty()) return std::nullopt;
  return candidates.front().pivot;
}

bool Eliminator::vanishes_nowhere(const Polynomial& f, const Facts& facts) {
  if (f.is_number()) return true;
  Polynomial multiplier = f.ring().constant(1);
  return std::ranges::all_of(factored(f, *stated_).powers, [&](const Power& power) {
    return sure(power, facts, multiplier).has_value();
  });
}

std::optional<EliminationFactor> Eliminator::sure(const Power& power, const Facts& facts,
                                                  Polynomial& multiplier) {
  for (std::size_t i = 0; i < facts.conditions.size(); ++i) {
    const auto& [formula, relation] = facts.conditions[i];
    if (!excludes_zero(relation) || formula.is_zero()) continue;
    const Polynomial scale = ratio(formula, power.base);
    if (scale.is_zero()) continue;
    multiplier = multiplier * scale.pow(power.exponent);
    return EliminationFactor{
        workshop_->write(formula), power.exponent, static_cast<int>(i), {}};
  }
  auto trees = nonvanishing_.show(power.base, Relation::nonzero, facts.conditions);
  if (!trees) return std::nullopt;
  return EliminationFactor{workshop_->write(power.base), power.exponent, -1, std::move(*trees)};
}

void Eliminator::step(const Combination& combination, const Polynomial& multiplier,
                      std::vector<EliminationFactor> factors) {
  EliminationStep product;
  product.combination = write(combination, multiplier);
  product.factors = std::move(factors);
  steps_.push_back(std::move(product));
}

certificate::Combination Eliminator::write(const Combination& combination,
                                           const Polynomial& multiplier) {
  certificate::Combination written;
  for (const auto& [equation, cofactor] : combination) {
    if (cofactor.is_zero()) continue;
    written.equations.push_back(equation);
    written.cofactors.push_back(workshop_->write(multiplier * cofactor));
  }
  return written;
}

Eliminator::Outcome Eliminator::derive(Facts& facts, Combination combination,
                                       const Polynomial& whole) {
  const Polynomial f = stated_->reduced(whole);
  if (f.is_zero()) return Outcome::goes_on;
  if (f.numerators().terms.size() > most_terms) {
    give_up("effort", "an equation of more than " + std::to_string(most_terms) + " terms");
    return Outcome::failed;
  }
  auto [multiplier, powers] = factored(f, *stated_);
  std::vector<EliminationFactor> factors;
  std::vector<Power> left;
  for (const Power& power : powers) {
    if (auto factor = sure(power, facts, multiplier))
      factors.push_back(std::move(*factor));
    else
      left.push_back(power);
  }
  if (left.empty()) {
    step(combination, multiplier, std::move(factors));
    return Outcome::closed;
  }
  const Polynomial one = f.ring().constant(1);
  const bool is_known = combination.size() == 1 && combination[0].second == one;
  const bool is_power = left.size() == 1 && left[0].exponent > 1;
  if (is_known && factors.empty() && !is_power && multiplier.is_number()) {
    facts.open.push_back({combination[0].first, {multiplier, left}});
    return Outcome::goes_on;
  }
  if (left.size() == 1) {
    factors.push_back({workshop_->write(left[0].base), left[0].exponent, -1, {}});
    left[0].exponent = 1;
  } else {
    factors.push_back({workshop_->write(multiplied(one, left)), 1, -1, {}});
  }
  step(combination, multiplier, std::move(factors));
  facts.equations.push_back(stated_->reduced(multiplied(one, left)));
  facts.open.push_back({static_cast<int>(facts.equations.size()) - 1, {one, left}});
  return Outcome::goes_on;
}

// All open equations again: more is known to vanish nowhere.
Eliminator::Outcome Eliminator::refresh(Facts& facts) {
  const auto before = std::exchange(facts.open, {});
  for (const Facts::Open& open : before) {
    const Polynomial f = facts.equations[open.equation];
    const Outcome outcome = derive(facts, {{open.equation, f.ring().constant(1)}}, f);
    if (outcome != Outcome::goes_on) return outcome;
  }
  return Outcome::goes_on;
}

Eliminator::Outcome Eliminator::reduce(Facts& facts, const Pivot& pivot) {
  const Facts::Open by = facts.open[pivot.place];
  const Polynomial divisor = facts.equations[by.equation];
  const Polynomial lead = initial(divisor, pivot.variable);
  auto before = std::exchange(facts.open, {});
  before.erase(before.begin() + static_cast<std::ptrdiff_t>(pivot.place));
  bool is_alone = true;
  for (Facts::Open& open : before) {
    const Polynomial f = facts.equations[open.equation];
    if (f.degree(pivot.variable) < pivot.degree) {
      is_alone = is_alone && f.degree(pivot.variable) < 1;
      facts.open.push_back(std::move(open));
      continue;
    }
    const auto [power, quotient, remainder] =
        pseudo_divide(*stated_, f, divisor, pivot.variable);
    const Outcome outcome =
        derive(facts, {{open.equation, lead.pow(power)}, {by.equation, -quotient}}, remainder);
    if (outcome != Outcome::goes_on) return outcome;
    is_alone = is_alone && remainder.degree(pivot.variable) < 1;
  }
  if (is_alone)
    facts.solved.push_back({pivot.variable, by.equation});
  else
    facts.open.push_back(by);
  return Outcome::goes_on;
}

// A case for each base. All are looked at, even when one fails: another may refute.
bool Eliminator::branch(const Facts& facts, std::size_t place) {
  const auto [equation, product] = facts.open[place];
  std::vector<EliminationFactor> factors;
  for (const Power& power : product.powers)
    factors.push_back({workshop_->write(power.base), power.exponent, -1, {}});
  step({{equation, product.multiplier.ring().constant(1)}}, product.multiplier, factors);
  bool all = true;
  for (const Power& power : product.powers) {
    Facts inner = facts;
    inner.open.erase(inner.open.begin() + static_cast<std::ptrdiff_t>(place));
    const Polynomial one = power.base.ring().constant(1);
    inner.equations.push_back(power.base);
    inner.open.push_back(
        {static_cast<int>(inner.equations.size()) - 1, {one, {{power.base, 1}}}});
    all = solve(std::move(inner)) && all;
    if (stopped_) return false;
  }
  return all;
}

// Whether the first factor of f that may vanish does.
bool Eliminator::distinguish(const Facts& facts, const Polynomial& f) {
  const Polynomial one = f.ring().constant(1);
  Polynomial multiplier = one;
  for (const Power& power : factored(f, *stated_).powers) {
    if (sure(power, facts, multiplier)) continue;
    EliminationStep cases;
    cases.kind = EliminationStep::Kind::cases;
    cases.formula = workshop_->write(power.base);
    steps_.push_back(std::move(cases));
    Facts zero = facts;
    zero.equations.push_back(power.base);
    zero.open.push_back(
        {static_cast<int>(zero.equations.size()) - 1, {one, {{power.base, 1}}}});
    const bool first = solve(std::move(zero));
    if (stopped_) return false;
    Facts nonzero = facts;
    nonzero.conditions.push_back({power.base, Relation::nonzero});
    const Outcome begun = refresh(nonzero);
    const bool second =
        begun == Outcome::closed || (begun == Outcome::goes_on && solve(std::move(nonzero)));
    return first && second;
  }
  return give_up("unsupported", "an initial that is 0");
}

}  // namespace seam::prove
