// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "bernstein/critical.h"
#include "prove/derive.h"
#include "prove/divide.h"

// The reductions of a derivation: each tries one way, and gives the proof or nothing.
//
//   f = A + B r has the conjugates A - B r and B r - A. The sums with f are 2 A and 2 B r, the
//   products A^2 - B^2 r^2 and its negative, in which r does not occur. Where A and B have no
//   constant sign, cases make them have one.

namespace seam::prove {

using certificate::Computation;
using certificate::Pieces;
using certificate::Reduction;
using certificate::Relation;
using certificate::SignProof;
using certificate::Step;
using exact::Polynomial;
using exact::Rational;
using exact::Sign;

namespace {

constexpr double tolerance = 1e-9;

Pieces plain() {
  return {{Step{}}, Relation::positive, -1, -1};
}

}  // namespace

Derivation::Shown Derivation::combination(const std::vector<Multiple>& multiples, Shown rest) {
  if (!rest) return std::nullopt;
  Reduction result{Reduction::Kind::combination, {}, {}, {std::move(*rest)}};
  for (const auto& [condition, cofactor] : multiples) {
    result.conditions.push_back(condition);
    result.terms.push_back(workshop_.write(cofactor));
    if (region_.where[condition].relation == Relation::zero) continue;
    if (cofactor.is_number())
      result.parts.push_back(Computation{});
    else
      result.parts.push_back(plain());
  }
  return result;
}

Derivation::Shown Derivation::by_equations(const Polynomial& f, Goal goal, int depth) {
  std::vector<Polynomial> equations;
  std::vector<int> origin;
  for (std::size_t i = 0; i < region_.given; ++i)
    if (region_.where[i].relation == Relation::zero) {
      equations.push_back(now(region_.where[i].formula));
      origin.push_back(static_cast<int>(i));
    }
  for (const Division& division : divisions(workshop_, f, equations)) {
    if (division.rest == f) continue;
    std::vector<Multiple> multiples;
    for (std::size_t i = 0; i < origin.size(); ++i)
      if (!division.cofactors[i].is_zero())
        multiples.push_back({origin[i], division.cofactors[i]});
    if (goal.side == 0 && !division.rest.is_zero()) continue;
    if (auto shown = combination(multiples, show(division.rest, goal, depth + 1))) return shown;
  }
  return std::nullopt;
}

// f = q * e with a condition that says of e, as then the proof says of q, on which side of 0 it
// is.
Derivation::Shown Derivation::by_factor(const Polynomial& f, Goal goal, int depth) {
  if (goal.strict() || depth == most_depth) return std::nullopt;
  for (std::size_t i = 0; i < region_.where.size(); ++i) {
    const Relation relation = region_.where[i].relation;
    if (relation == Relation::zero || relation == Relation::nonzero) continue;
    const int side = goal.side * (holds(relation, Sign::positive) ? 1 : -1);
    for (const Division& division :
         divisions(workshop_, now(f), {now(region_.where[i].formula)})) {
      if (!division.rest.is_zero()) continue;
      auto sign = show(division.cofactors[0], weak(side), depth + 1);
      if (!sign) continue;
      return Reduction{Reduction::Kind::combination,
                       {workshop_.write(division.cofactors[0])},
                       {static_cast<int>(i)},
                       {Computation{}, std::move(*sign)}};
    }
  }
  return std::nullopt;
}

Derivation::Shown Derivation::by_multiplier(const Linear& f, Goal goal, int depth) {
  const bool any_sign = goal.relation == Relation::nonzero;
  for (const int scale : {1, -1}) {
    const Polynomial h = Rational(scale) * (f.constant - f.factor * f.root);
    if (!any_sign && !is_plausible(h, upward(true))) continue;
    const Goal of_product = any_sign ? Goal{goal.relation, 1} : goal;
    auto product = show(Rational(scale) * f.norm, of_product, depth + 1);
    if (!product) continue;
    auto positive = any_sign ? Shown(Computation{}) : show(h, upward(true), depth + 1);
    if (!positive) continue;
    return Reduction{Reduction::Kind::multiplier,
                     {workshop_.write(h)},
                     {},
                     {std::move(*positive), std::move(*product)}};
  }
  return std::nullopt;
}

Derivation::Shown Derivation::by_conjugate(const Linear& f, Goal goal, int depth) {
  for (const bool of_constant : {true, false}) {
    const Rational scale(of_constant ? 1 : -1);
    const Polynomial product = scale * f.norm;
    if (!is_plausible(product, upward(goal.strict()))) continue;
    auto is_sum = sum(f, of_constant, goal, depth);
    if (!is_sum) continue;
    auto is_product = show(product, upward(goal.strict()), depth + 1);
    if (!is_product) continue;
    const Polynomial h = scale * (now(f.constant) - now(f.factor) * now(f.root));
    return Reduction{Reduction::Kind::conjugate,
                     {workshop_.write(h)},
                     {},
                     {std::move(*is_sum), std::move(*is_product)}};
  }
  return std::nullopt;
}

// That 2 A, or 2 B r, has the sign of the goal, or is 0. The pieces that show it for B do so
// for B r: each coefficient of the one is a coefficient of the other.
Derivation::Shown Derivation::sum(const Linear& f, bool of_constant, Goal goal, int depth) {
  const Polynomial& a = of_constant ? f.constant : f.factor;
  if (of_constant) return show(Rational(2) * a, weak(goal.side), depth + 1);
  if (auto shown = by_factor(Rational(2) * a * f.root, weak(goal.side), depth)) return shown;
  auto shown = show(a, weak(goal.side), depth + 1);
  if (shown && std::holds_alternative<Computation>(*shown)) return plain();
  const auto* pieces = shown ? std::get_if<Pieces>(&*shown) : nullptr;
  return pieces != nullptr && pieces->square < 0 ? shown : std::nullopt;
}

std::optional<Derivation::Known> Derivation::known(const Polynomial& a, int side) const {
  for (std::size_t i = region_.known; i < region_.where.size(); ++i)
    for (const int scale : {1, -1}) {
      const int upward = holds(region_.where[i].relation, Sign::positive) ? 1 : -1;
      if (upward * scale != side) continue;
      if (now(a) == Rational(scale) * now(region_.where[i].formula))
        return Known{static_cast<int>(i), scale};
    }
  return std::nullopt;
}

// f = A + B r from what the case says of A, of B, or of both.
Derivation::Shown Derivation::by_conditions(const Linear& f, Goal goal, int depth) {
  if (goal.relation == Relation::nonzero) return std::nullopt;
  const auto of_constant = known(f.constant, goal.side);
  const auto of_factor = known(f.factor, goal.side);
  const auto by_constant = [&] {
    return Multiple{of_constant->condition, f.root.ring().constant(of_constant->scale)};
  };
  const auto by_factor = [&] {
    return Multiple{of_factor->condition, Rational(of_factor->scale) * f.root};
  };
  if (of_constant && of_factor && !goal.strict())
    return combination({by_constant(), by_factor()}, Computation{});
  if (of_constant)
    if (auto shown = combination({by_constant()}, show(f.factor * f.root, goal, depth + 1)))
      return shown;
  if (of_factor) return combination({by_factor()}, show(f.constant, goal, depth + 1));
  return std::nullopt;
}

Derivation::Shown Derivation::by_cases(const Polynomial& f, const Linear& parts, Goal goal,
                                       int depth) {
  for (const Polynomial& divider : {parts.factor, parts.constant}) {
    if (divider.is_number() || known(divider, 1) || known(divider, -1)) continue;
    const bernstein::Sketch sketch(divider);
    bool above = false, below = false;
    for (const Sample& sample : samples_) {
      const double v = sketch.jet(sample.values).value;
      above = above || v > tolerance;
      below = below || v < -tolerance;
    }
    // If it has one sign, `above` is the only case.
    const Polynomial a = below && !above ? -divider : divider;
    Shown first = in_case(a, Relation::nonnegative, f, goal, depth);
    if (!first) continue;
    Shown second;
    if (above && below) {
      second = in_case(a, Relation::negative, f, goal, depth);
    } else if (auto shown = show(a, weak(1), depth + 1)) {
      // Where a >= 0 is plain, a < 0 is broken.
      if (auto* pieces = std::get_if<Pieces>(&*shown); pieces && pieces->square < 0) {
        for (Step& step : pieces->steps)
          if (step.kind == Step::Kind::plain)
            step = {Step::Kind::outside, static_cast<int>(region_.where.size()), {}};
        second = std::move(shown);
      }
    }
    if (!second) continue;
    return Reduction{Reduction::Kind::cases,
                     {workshop_.write(a)},
                     {},
                     {std::move(*first), std::move(*second)}};
  }
  return std::nullopt;
}

Derivation::Shown Derivation::in_case(const Polynomial& a, Relation relation,
                                      const Polynomial& f, Goal goal, int depth) {
  const bernstein::Sketch sketch(a);
  std::vector<Sample> inside;
  for (const Sample& sample : samples_) {
    const double v = sketch.jet(sample.values).value;
    if (relation == Relation::negative ? v < -tolerance : v > -tolerance)
      inside.push_back(sample);
  }
  std::swap(samples_, inside);
  region_.where.push_back({a, relation});
  Shown shown = show(f, goal, depth + 1);
  region_.where.pop_back();
  std::swap(samples_, inside);
  return shown;
}

}  // namespace seam::prove
