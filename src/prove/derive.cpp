// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/derive.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "bernstein/critical.h"
#include "prove/divide.h"
#include "prove/sign.h"

// Every reduction leads to a formula with one function less, or to a region with a case more,
// of which there are two for each formula; the depth is bounded besides. Values at samples, in
// doubles, say which way is worth while; nothing rests on them.

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

constexpr long few_pieces = 150;
constexpr long some_pieces = 3000;
constexpr std::size_t few_samples = 300;
constexpr int most_exact = 40;    // points that are evaluated without new numbers
constexpr int most_adjoined = 4;  // and with
constexpr double tolerance = 1e-9;

double value(const bernstein::Sketch& sketch, const Sample& sample) {
  return sketch.jet(sample.values).value;
}

}  // namespace

bool Derivation::Goal::strict() const {
  return !holds(relation, Sign::zero);
}
Derivation::Goal Derivation::upward(bool strict) {
  return {strict ? Relation::positive : Relation::nonnegative, 1};
}
Derivation::Goal Derivation::weak(int side) {
  return {side > 0 ? Relation::nonnegative : Relation::nonpositive, side};
}

Derivation::Derivation(Workshop& workshop, Region region)
    : workshop_(workshop), region_(std::move(region)), samples_(samples(workshop, region_)) {}

Polynomial Derivation::now(const Polynomial& f) const {
  return workshop_.ring(f.ring().variables())->embed(f);
}

bool Derivation::holds_function(const Polynomial& f) const {
  const int count = static_cast<int>(f.ring().variables().size());
  for (int v = count - static_cast<int>(region_.functions.size()); v < count; ++v)
    if (f.degree(v) > 0) return true;
  return false;
}

std::optional<Derivation::Linear> Derivation::linear(const Polynomial& old) {
  const Polynomial f = now(old);
  const int count = static_cast<int>(f.ring().variables().size());
  const int first = count - static_cast<int>(region_.functions.size());
  int v = count - 1;
  while (v >= first && f.degree(v) <= 0) --v;
  if (v < first || !region_.functions[v - first]->is_root() ||
      region_.functions[v - first]->degree != 2)
    return std::nullopt;
  Linear result{f.ring().constant(0), f.ring().constant(0), f.ring().variable(v),
                f.ring().constant(0)};
  for (const auto& [exponents, coefficient] : f.coefficients({v}))
    (exponents.front() == 0 ? result.constant : result.factor) = coefficient;
  const Polynomial conjugate = result.constant - result.factor * result.root;
  result.norm = workshop_.reduced(f * conjugate);
  return result;
}

bool Derivation::is_plausible(const Polynomial& f, Goal goal) const {
  const bernstein::Sketch sketch(f);
  const std::size_t count = std::min(samples_.size(), few_samples);
  return std::all_of(
      samples_.begin(), samples_.begin() + static_cast<long>(count), [&](const Sample& sample) {
        const double v = value(sketch, sample);
        return goal.side == 0 ? std::abs(v) < tolerance : goal.side * v > -tolerance;
      });
}

std::optional<SignProof> Derivation::show(const Polynomial& f, Relation relation) {
  if (region_.holds_log()) return std::nullopt;
  switch (relation) {
    case Relation::positive:
    case Relation::nonnegative:
      return show(f, {relation, 1}, 0);
    case Relation::negative:
    case Relation::nonpositive:
      return show(f, {relation, -1}, 0);
    case Relation::zero:
      return show(f, {relation, 0}, 0);
    case Relation::nonzero:
      if (auto above = show(f, {relation, 1}, 0)) return above;
      return show(f, {relation, -1}, 0);
  }
  return std::nullopt;
}

Derivation::Shown Derivation::show(Polynomial f, Goal goal, int depth) {
  if (workshop_.late()) return std::nullopt;
  f = now(f);
  if (f.is_number()) {
    if (!holds(goal.relation, exact::sign(workshop_.numbers()->embed(f)))) return std::nullopt;
    return Computation{};
  }
  if (!is_plausible(f, goal)) return std::nullopt;
  if (goal.side == 0) return show_zero(f, depth);
  if (auto shown = by_factor(f, goal, depth)) return shown;
  f = now(f);  // the tower may have grown
  const bool is_free = !holds_function(f);
  const long effort = depth == 0 && is_free ? workshop_.budget().effort : some_pieces;
  if (is_free)
    if (auto shown = subdivide(f, goal, true, effort)) return shown;
  if (!is_free || !region_.functions.empty())
    if (auto shown = subdivide(f, goal, false, few_pieces)) return shown;
  if (depth == most_depth) return std::nullopt;
  f = now(f);
  if (depth == 0)
    if (auto shown = by_equations(f, goal, depth)) return shown;
  if (const auto parts = linear(f)) {
    if (auto shown = by_conditions(*parts, goal, depth)) return shown;
    if (auto shown = goal.relation == Relation::nonzero ? by_multiplier(*parts, goal, depth)
                                                        : by_conjugate(*parts, goal, depth))
      return shown;
    if (auto shown = by_cases(f, *parts, goal, depth)) return shown;
  }
  if (depth > 0 || is_free) return std::nullopt;
  return subdivide(f, goal, false, workshop_.budget().effort);
}

Derivation::Shown Derivation::show_zero(const Polynomial& f, int depth) {
  const Goal goal{Relation::zero, 0};
  if (auto shown = by_equations(f, goal, depth)) return shown;
  const auto parts = linear(f);
  if (!parts || depth == most_depth) return std::nullopt;
  if (auto shown = by_multiplier(*parts, goal, depth)) return shown;
  auto above = show(f, weak(1), depth + 1);
  auto below = above ? show(f, weak(-1), depth + 1) : std::nullopt;
  if (!below) return std::nullopt;
  return Reduction{Reduction::Kind::both, {}, {}, {std::move(*above), std::move(*below)}};
}

// Without the coordinates of functions if `is_free`, and the conditions that hold them.
Derivation::Shown Derivation::subdivide(const Polynomial& f, Goal goal, bool is_free,
                                        long effort) {
  Question question{region_.factors, f, goal.strict(), {}, is_free};
  if (is_free) question.factors.resize(region_.factors.size() - region_.functions.size(), {});
  if (question.factors.empty()) return std::nullopt;
  const auto ring = workshop_.ring(variables(question.factors));
  question.f = Rational(goal.side) * ring->embed(f);
  std::vector<int> origin;
  for (std::size_t i = 0; i < region_.where.size(); ++i) {
    const auto& [formula, relation] = region_.where[i];
    if (is_free && holds_function(formula)) continue;
    question.where.push_back({ring->embed(formula), relation});
    origin.push_back(static_cast<int>(i));
  }
  Answer answer = decide(workshop_, std::move(question), effort);
  if (answer.kind == Answer::Kind::no && is_free) places_.push_back(std::move(answer.place));
  if (answer.kind != Answer::Kind::yes) return std::nullopt;
  for (Step& step : answer.pieces.steps)
    if (step.kind == Step::Kind::outside)
      step.index = origin[static_cast<std::size_t>(step.index)];
  answer.pieces.side = goal.side > 0 ? Relation::positive : Relation::negative;
  // The question was about -f = square^2 * cofactor.
  if (goal.side < 0 && answer.pieces.cofactor >= 0)
    answer.pieces.cofactor = workshop_.negated(answer.pieces.cofactor);
  return answer.pieces;
}

std::optional<certificate::Point> Derivation::refute(const Polynomial& f, Relation relation) {
  const bernstein::Sketch sketch(f);
  std::vector<const Place*> candidates;
  for (const Place& place : places_) candidates.push_back(&place);
  for (const Sample& sample : samples_) {
    const double v = value(sketch, sample);
    const Sign about = std::abs(v) < tolerance ? Sign::zero
                       : v > 0                 ? Sign::positive
                                               : Sign::negative;
    if (!holds(relation, about)) candidates.push_back(&sample.place);
  }
  for (const bool may_adjoin : {false, true}) {
    int left = may_adjoin ? most_adjoined : most_exact;
    for (const Place* place : candidates) {
      if (left-- == 0 || workshop_.late()) break;
      if (auto point = witness(workshop_, region_, now(f), relation, *place, may_adjoin))
        return point;
    }
  }
  return std::nullopt;
}

}  // namespace seam::prove
