// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "prove/derive.h"
#include "prove/linear_program.h"

// f = rest + sum h_i e_i with conditions e_i >= 0 and cofactors h_i >= 0, or any h_i where
// e_i = 0. The h_i are sought among sums of few candidates with factors >= 0: 1, and products
// of the distances of a coordinate from the ends of its interval. That no coefficient of the
// rest in barycentric coordinates is negative is a system of linear inequalities for the
// factors. Nothing rests on the search: the rest and the h_i are shown like any other sign.

namespace seam::prove {

using certificate::Relation;
using exact::Exponents;
using exact::Polynomial;
using exact::Rational;
using exact::Sign;

namespace {

constexpr std::size_t most_candidates = 80;
constexpr std::size_t most_rows = 600;
constexpr int most_degree = 2;  // of a cofactor

// The coefficients over the factors, all in one degree for each factor.
class Coefficients {
 public:
  Coefficients(const Factors& factors, std::vector<int> degrees)
      : factors_(factors), degrees_(std::move(degrees)) {}

  // Nothing if one is no rational number.
  std::optional<std::map<Exponents, Rational>> of(const Polynomial& f) const {
    Polynomial form = in_barycentric(factors_, f).polynomial;
    const exact::Ring& ring = form.ring();
    int first = 0, offset = 0;
    for (std::size_t k = 0; k < factors_.size(); ++k) {
      std::vector<int> own;
      for (std::size_t j = 0; j < factors_[k].variables.size(); ++j) own.push_back(first++);
      Polynomial weight = ring.constant(0);
      for (const auto& corner : factors_[k].corners)
        weight = weight + ring.embed(corner.front()) * ring.variable(offset++);
      form = form * weight.pow(degrees_[k] - std::max(0, f.degree(own)));
    }
    std::map<Exponents, Rational> result;
    std::vector<int> all;
    for (std::size_t i = 0; i < ring.variables().size(); ++i)
      all.push_back(static_cast<int>(i));
    for (const auto& [exponents, coefficient] : form.coefficients(all)) {
      const auto value = coefficient.rational();
      if (!value) return std::nullopt;
      result.emplace(exponents, *value);
    }
    return result;
  }

 private:
  const Factors& factors_;
  std::vector<int> degrees_;
};

std::vector<int> degrees(const Factors& factors, const Polynomial& f) {
  std::vector<int> result;
  int first = 0;
  for (const Factor& factor : factors) {
    std::vector<int> own;
    for (std::size_t j = 0; j < factor.variables.size(); ++j) own.push_back(first++);
    result.push_back(std::max(0, f.degree(own)));
  }
  return result;
}

// The distances of the coordinates from the ends of their intervals.
std::vector<Polynomial> distances(const Factors& factors, const exact::Ring& ring) {
  std::vector<Polynomial> result;
  int place = 0;
  for (const Factor& factor : factors) {
    if (factor.corners.size() == 2) {
      const Polynomial x = ring.variable(place);
      for (std::size_t end = 0; end < 2; ++end) {
        const auto &here = factor.corners[end], &there = factor.corners[1 - end];
        if (here.front().is_zero()) continue;
        // weight * x - coordinate vanishes at this end, and has the sign of the other end.
        const Polynomial d = ring.embed(here[0]) * x - ring.embed(here[1]);
        const Polynomial other = here[0] * there[1] - here[1] * there[0];
        result.push_back(exact::sign(other) == Sign::positive ? d : -d);
      }
    }
    place += static_cast<int>(factor.variables.size());
  }
  return result;
}

// Whether a monomial in barycentric coordinates is not 0 at some corner that is no point at
// infinity.
bool is_corner(const Factors& factors, const Exponents& exponents) {
  std::size_t place = 0;
  for (const Factor& factor : factors) {
    int held = 0;
    for (std::size_t i = 0; i < factor.corners.size(); ++i) {
      if (exponents[place++] == 0) continue;
      if (++held > 1 || (factor.infinite >> i & 1U) != 0) return false;
    }
  }
  return true;
}

std::vector<Polynomial> multipliers(const Factors& factors, const exact::Ring& ring,
                                    int degree) {
  std::vector<Polynomial> result = {ring.constant(1)};
  const auto linear = distances(factors, ring);
  std::size_t begin = 0;
  for (int d = 1; d <= degree; ++d) {
    const std::size_t end = result.size();
    for (std::size_t i = begin; i < end; ++i)
      for (const Polynomial& l : linear) {
        const Polynomial next = result[i] * l;
        if (std::ranges::find(result, next) == result.end()) result.push_back(next);
      }
    begin = end;
  }
  return result;
}

}  // namespace

std::optional<certificate::SignProof> Derivation::combine(const Polynomial& f,
                                                          Relation relation) {
  if (relation == Relation::zero) {
    auto above = by_inequalities(now(f), {Relation::nonnegative, 1});
    auto below = by_inequalities(now(f), {Relation::nonpositive, -1});
    if (!above || !below) return std::nullopt;
    return certificate::Reduction{
        certificate::Reduction::Kind::both, {}, {}, {std::move(*above), std::move(*below)}};
  }
  if (!holds(relation, Sign::positive)) return by_inequalities(now(f), {relation, -1});
  return by_inequalities(now(f), {relation, holds(relation, Sign::negative) ? 0 : 1});
}

Derivation::Shown Derivation::by_inequalities(const Polynomial& f, Goal goal) {
  if (goal.side == 0 || goal.relation == Relation::nonzero || !region_.functions.empty())
    return std::nullopt;
  const exact::Ring& ring = f.ring();
  std::vector<int> everything;
  for (std::size_t i = 0; i < ring.variables().size(); ++i)
    everything.push_back(static_cast<int>(i));

  // With sign 1 or -1 so that the condition is >= 0, or = 0.
  struct Candidate {
    int condition;
    Polynomial cofactor, product;
  };
  std::vector<Candidate> candidates;
  std::vector<int> top = degrees(region_.factors, f);
  for (std::size_t i = 0; i < region_.where.size(); ++i) {
    const Relation relation = region_.where[i].relation;
    if (relation == Relation::nonzero) continue;
    const Polynomial e = now(region_.where[i].formula);
    const int left = std::min(most_degree, f.degree(everything) - e.degree(everything));
    if (left < 0) continue;
    const bool both = relation == Relation::zero;
    const int side = holds(relation, Sign::negative) && !both ? -1 : 1;
    for (const Polynomial& h : multipliers(region_.factors, ring, left))
      for (const int sign : {side, -side}) {
        if (sign == -side && !both) continue;
        const Polynomial cofactor = Rational(sign) * h;
        candidates.push_back({static_cast<int>(i), cofactor, cofactor * e});
        const auto own = degrees(region_.factors, candidates.back().product);
        for (std::size_t k = 0; k < top.size(); ++k) top[k] = std::max(top[k], own[k]);
      }
  }
  if (candidates.empty() || candidates.size() > most_candidates) return std::nullopt;

  const Coefficients coefficients(region_.factors, top);
  const auto wanted = coefficients.of(Rational(goal.side) * f);
  if (!wanted) return std::nullopt;
  std::map<Exponents, std::vector<Rational>> rows;
  const std::size_t width = candidates.size() + 1;
  const auto row = [&](const Exponents& exponents) -> std::vector<Rational>& {
    return rows.try_emplace(exponents, width).first->second;
  };
  for (const auto& [exponents, value] : *wanted) row(exponents);
  for (std::size_t j = 0; j < candidates.size(); ++j) {
    const auto found = coefficients.of(candidates[j].product);
    if (!found) return std::nullopt;
    for (const auto& [exponents, value] : *found) row(exponents)[j] = value;
  }
  if (rows.size() > most_rows) return std::nullopt;
  std::vector<std::vector<Rational>> left;
  std::vector<Rational> right;
  for (auto& [exponents, entries] : rows) {
    // At the finite corners the rest is to be as large as it can be.
    if (is_corner(region_.factors, exponents)) entries.back() = 1;
    left.push_back(entries);
    const auto value = wanted->find(exponents);
    right.push_back(value == wanted->end() ? Rational(0) : value->second);
  }
  left.emplace_back(width);
  left.back().back() = 1;
  right.emplace_back(1);
  auto factors = linear_program(left, right);
  if (!factors) return std::nullopt;

  Polynomial rest = f;
  std::map<int, Polynomial> cofactors;
  for (std::size_t j = 0; j < candidates.size(); ++j) {
    if ((*factors)[j] == 0) continue;
    const Rational factor = Rational(goal.side) * (*factors)[j];
    rest = rest - factor * candidates[j].product;
    const Polynomial h = factor * candidates[j].cofactor;
    const auto [place, fresh] = cofactors.emplace(candidates[j].condition, h);
    if (!fresh) place->second = place->second + h;
  }
  if (cofactors.empty()) return std::nullopt;
  std::vector<Multiple> multiples;
  for (const auto& [condition, h] : cofactors) multiples.push_back({condition, h});
  return combination(multiples, show(rest, goal, most_depth));
}

}  // namespace seam::prove
