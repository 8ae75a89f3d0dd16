// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "prove/linear.h"
#include "prove/newton.h"
#include "prove/sampling.h"
#include "prove/strategies.h"
#include "prove/subdivide.h"

// Newton's method from many points guesses where solutions are. With the inverse of the
// Jacobian there as the combination, G is nearly x - solution: so its signs on the faces of a
// small box and its diagonal dominance on a larger one are plain. Boxes are halved until they
// are; each loop has a bound, and each subdivision a number of pieces.

namespace seam::prove {

using certificate::Box;
using certificate::Isolation;
using certificate::Nothing;
using certificate::OneSolution;
using certificate::Pieces;
using certificate::Proof;
using certificate::Relation;
using exact::Polynomial;
using exact::Rational;
using exact::Sign;

namespace {

constexpr int most_starts = 200;
constexpr int most_halvings = 40;
constexpr long most_pieces = 1000;
constexpr double same_point = 1e-8;

using Place = std::vector<double>;
using Bounds = std::vector<std::pair<Rational, Rational>>;

// A rational near x, on a grid finer than `scale`.
Rational near(double x, double scale) {
  const int exponent = std::max(0, 12 - std::ilogb(scale));
  Rational result;
  mpq_set_d(result.get_mpq_t(), std::floor(std::ldexp(x, exponent)));
  mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), exponent);
  return result;
}

Box box(const Bounds& bounds) {
  Box result;
  for (const auto& [low, high] : bounds) {
    result.low.push_back(low.get_str());
    result.high.push_back(high.get_str());
  }
  return result;
}

class OneSolutionProof {
 public:
  OneSolutionProof(Workshop& workshop, const OneSolution& stated)
      : workshop_(workshop), stated_(stated), ring_(workshop.ring(stated.unknowns)) {
    for (const auto& simplex : stated.domain.factors)
      factors_.push_back(make_factor(workshop, simplex));
    std::vector<std::string> all = stated.for_all;
    std::vector<int> bound;
    for (std::size_t i = 0; i < all.size(); ++i) bound.push_back(static_cast<int>(i));
    all.insert(all.end(), stated.unknowns.begin(), stated.unknowns.end());
    for (const certificate::Term term : stated.system)
      for (const auto& [exponents, f] : workshop.expand(term, all).coefficients(bound))
        equations_.push_back(ring_->embed(f));
    for (const auto& condition : stated.domain.where)
      conditions_.push_back(
          {workshop.expand(condition.formula, stated.unknowns), condition.relation});
    for (std::size_t j = 0; j < stated.low.size(); ++j)
      printed_.emplace_back(Rational(stated.low[j]), Rational(stated.high[j]));
  }

  Proof prove() {
    if (equations_.size() != printed_.size())
      return Nothing{"unsupported", "one solution of a system with " +
                                        std::to_string(equations_.size()) + " equations in " +
                                        std::to_string(printed_.size()) + " unknowns"};
    for (const Polynomial& f : equations_) sketches_.emplace_back(f);
    const std::vector<Place> found = guesses();
    const Place* inside = nullptr;
    for (const Place& place : found) {
      if (is_printed(place)) {
        inside = &place;
        continue;
      }
      if (auto refutation = isolated(place, false)) return std::move(*refutation);
    }
    if (!inside) return none();
    if (auto proof = isolated(*inside, true)) return std::move(*proof);
    return Nothing{"effort", "no boxes were found that show one solution and no other"};
  }

 private:
  std::vector<Place> guesses() const {
    std::vector<Place> starts = sample(factors_in_order(), 0, most_starts);
    Place middle;
    for (const auto& [low, high] : printed_)
      middle.push_back(Rational((low + high) / 2).get_d());
    starts.insert(starts.begin(), middle);
    std::vector<Place> found;
    for (const Place& start : starts) {
      Place place = newton(sketches_, start);
      if (place.empty() || !may_be_in_domain(place)) continue;
      const auto same = [&](const Place& other) {
        for (std::size_t j = 0; j < place.size(); ++j)
          if (std::abs(place[j] - other[j]) > same_point) return false;
        return true;
      };
      if (std::ranges::none_of(found, same)) found.push_back(std::move(place));
    }
    return found;
  }

  // One factor an unknown, in the order of the unknowns.
  Factors factors_in_order() const {
    Factors result;
    for (const std::string& name : stated_.unknowns)
      for (const Factor& factor : factors_)
        if (factor.variables.front() == name) result.push_back(factor);
    return result;
  }

  bool may_be_in_domain(const Place& place) const {
    const Factors factors = factors_in_order();
    for (std::size_t j = 0; j < factors.size(); ++j) {
      std::vector<std::vector<double>> corners;
      for (const auto& corner : factors[j].corners)
        corners.push_back({exact::ball(corner[0]).middle, exact::ball(corner[1]).middle});
      const auto l = barycentric(corners, std::vector{1.0, place[j]});
      const double total = 1 + place[j];
      if (l.empty() || total == 0) return false;
      for (const double share : l)
        if (share * (total > 0 ? 1 : -1) < 0) return false;
    }
    return std::ranges::all_of(conditions_, [&](const Condition& c) {
      const double value = about(c.formula, place);
      return holds(c.relation, value > 0   ? Sign::positive
                               : value < 0 ? Sign::negative
                                           : Sign::zero);
    });
  }

  bool is_printed(const Place& place) const {
    for (std::size_t j = 0; j < place.size(); ++j)
      if (place[j] < printed_[j].first.get_d() || place[j] > printed_[j].second.get_d())
        return false;
    return true;
  }

  // Pieces for `f relation 0` over a box, or over the domain with the system as conditions.
  std::optional<Pieces> show(const Polynomial& f, Relation relation, const Factors& factors,
                             const std::vector<Condition>& where, long pieces) const {
    const exact::RingPtr ring = workshop_.ring(variables(factors));
    for (const int side : {1, -1}) {
      if (!holds(relation, side > 0 ? Sign::positive : Sign::negative)) continue;
      Question question{
          factors, ring->embed(Rational(side) * f), !holds(relation, Sign::zero), {}};
      for (const auto& [formula, is] : where)
        question.where.push_back({ring->embed(formula), is});
      Subdivision subdivision(workshop_, question, {});
      if (subdivision.run(std::min(pieces, workshop_.budget().effort)) ==
          Subdivision::Outcome::proved)
        return Pieces{subdivision.steps(), side > 0 ? Relation::positive : Relation::negative};
    }
    return std::nullopt;
  }

  Factors factors_of(const Bounds& bounds, std::size_t left_out) const {
    const exact::RingPtr numbers = workshop_.numbers();
    Factors result;
    for (std::size_t j = 0; j < bounds.size(); ++j) {
      const auto corner = [&](const Rational& x) {
        return std::vector{numbers->constant(1), numbers->constant(x)};
      };
      if (j != left_out)
        result.push_back({{stated_.unknowns[j]},
                          {corner(bounds[j].first), corner(bounds[j].second)},
                          {false, false},
                          0});
    }
    return result;
  }

  static Bounds around(const Place& place, double radius) {
    Bounds result;
    for (const double x : place)
      result.emplace_back(near(x - radius, radius), near(x + radius, radius));
    return result;
  }

  bool is_inside(const Bounds& bounds) const {
    const exact::RingPtr numbers = workshop_.numbers();
    const Factors factors = factors_in_order();
    for (std::size_t j = 0; j < bounds.size(); ++j)
      for (const Rational& x : {bounds[j].first, bounds[j].second}) {
        const auto l =
            barycentric(factors[j].corners, {numbers->constant(1), numbers->constant(x)});
        for (std::size_t i = 0; i < l.size(); ++i) {
          const Sign s = exact::sign(l[i]);
          if (s == Sign::negative || (s == Sign::zero && factors[j].open[i])) return false;
        }
      }
    return true;
  }

  bool is_placed(const Bounds& bounds, bool within) const {
    bool apart = false, inside = true;
    for (std::size_t j = 0; j < bounds.size(); ++j) {
      const auto& [low, high] = printed_[j];
      apart = apart || bounds[j].second < low || bounds[j].first > high;
      inside = inside && bounds[j].first >= low && bounds[j].second <= high;
    }
    return within ? inside : apart;
  }

  // With `alone` the whole proof for the solution near the place; else that there is one there.
  std::optional<Proof> isolated(const Place& place, bool alone) {
    const auto inverse = inverse_jacobian(sketches_, place);
    if (inverse.empty()) return std::nullopt;
    Isolation result;
    std::vector<Polynomial> combined;
    for (const auto& row : inverse) {
      result.combination.emplace_back();
      Polynomial sum = ring_->constant(0);
      for (std::size_t j = 0; j < row.size(); ++j) {
        const Rational entry = near(row[j], std::max(1e-6, std::abs(row[j])));
        result.combination.back().push_back(entry.get_str());
        sum = sum + entry * equations_[j];
      }
      combined.push_back(std::move(sum));
    }
    double radius = alone ? 0.125 : 0x1p-13;  // what refutes is shown: some digits are wanted
    bool is_found = false;
    for (int n = 0; n < most_halvings && !is_found && !workshop_.late(); ++n, radius /= 2)
      is_found = find_inner(around(place, radius), combined, alone, result);
    if (!is_found) return std::nullopt;
    if (!alone) return result;
    radius = 1;
    is_found = false;
    for (int n = 0; n < most_halvings && !is_found && !workshop_.late(); ++n, radius /= 2)
      is_found = find_outer(around(place, radius), combined, result);
    if (!is_found) return std::nullopt;
    return result;
  }

  bool find_inner(const Bounds& bounds, const std::vector<Polynomial>& combined, bool within,
                  Isolation& result) const {
    if (!is_placed(bounds, within) || !is_inside(bounds)) return false;
    result.inner = box(bounds);
    result.faces.clear();
    result.conditions.clear();
    for (std::size_t j = 0; j < bounds.size(); ++j)
      for (const bool high : {false, true}) {
        std::vector<Polynomial> values;
        for (std::size_t i = 0; i < bounds.size(); ++i)
          values.push_back(ring_->variable(static_cast<int>(i)));
        values[j] = ring_->constant(high ? bounds[j].second : bounds[j].first);
        auto tree = show(combined[j].substitute(ring_, values),
                         high ? Relation::positive : Relation::negative, factors_of(bounds, j),
                         {}, most_pieces);
        if (!tree) return false;
        result.faces.push_back(std::move(*tree));
      }
    for (const auto& [formula, relation] : conditions_) {
      auto tree = show(formula, relation, factors_of(bounds, bounds.size()), {}, most_pieces);
      if (!tree) return false;
      result.conditions.push_back(std::move(*tree));
    }
    return true;
  }

  bool find_outer(const Bounds& bounds, const std::vector<Polynomial>& combined,
                  Isolation& result) const {
    for (std::size_t j = 0; j < bounds.size(); ++j)
      if (bounds[j].first > Rational(result.inner.low[j]) ||
          bounds[j].second < Rational(result.inner.high[j]))
        return false;
    const Factors factors = factors_of(bounds, bounds.size());
    const std::size_t n = bounds.size();
    result.outer = box(bounds);
    result.dominance.clear();
    result.cover.clear();
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t signs = 0; signs < std::size_t{1} << (n - 1); ++signs) {
        Polynomial sum = combined[i].derivative(static_cast<int>(i));
        std::size_t left = signs;
        for (std::size_t j = 0; j < n; ++j) {
          if (j == i) continue;
          const Polynomial slope = combined[i].derivative(static_cast<int>(j));
          sum = left % 2 == 0 ? sum + slope : sum - slope;
          left /= 2;
        }
        auto tree = show(sum, Relation::positive, factors, {}, most_pieces);
        if (!tree) return false;
        result.dominance.push_back(std::move(*tree));
      }
    const auto where = solutions(combined);
    for (std::size_t j = 0; j < n; ++j)
      for (const bool high : {false, true}) {
        const Polynomial x = ring_->variable(static_cast<int>(j));
        auto tree = show(
            high ? ring_->constant(bounds[j].second) - x : x - ring_->constant(bounds[j].first),
            Relation::nonnegative, factors_, where, workshop_.budget().effort);
        if (!tree) return false;
        result.cover.push_back(std::move(*tree));
      }
    return true;
  }

  std::vector<Condition> solutions(const std::vector<Polynomial>& combined) const {
    auto where = conditions_;
    for (const auto* formulas : {&equations_, &combined})
      for (const Polynomial& f : *formulas) where.push_back({f, Relation::zero});
    return where;
  }

  Proof none() const {
    auto tree = show(ring_->constant(-1), Relation::nonnegative, factors_, solutions({}),
                     workshop_.budget().effort);
    if (!tree)
      return Nothing{"effort",
                     "no solution was found where one is claimed, nor that there is none"};
    Isolation result;
    result.cover.push_back(std::move(*tree));
    return result;
  }

  Workshop& workshop_;
  const OneSolution& stated_;
  exact::RingPtr ring_;
  Factors factors_;
  std::vector<Polynomial> equations_;
  std::vector<Condition> conditions_;
  Bounds printed_;
  std::vector<bernstein::Sketch> sketches_;
};

}  // namespace

Proof prove_one_solution(Workshop& workshop, const OneSolution& stated) {
  return OneSolutionProof(workshop, stated).prove();
}

}  // namespace seam::prove
