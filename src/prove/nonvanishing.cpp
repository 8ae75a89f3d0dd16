// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/nonvanishing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "prove/derive.h"
#include "prove/sampling.h"

// Samples first: what takes the wrong sign at one of them needs no search. Ends because each
// search is given a number of pieces, and there are 2^k of them.

namespace seam::prove {

using certificate::Pieces;
using certificate::Relation;
using certificate::SignProof;
using exact::Polynomial;
using exact::Sign;

namespace {

constexpr long most_pieces = 2000;
constexpr int most_samples = 120;
constexpr std::size_t most_halved = 4;
constexpr double small = 1e-12;

Sign sign_of(double value) {
  return value > small ? Sign::positive : value < -small ? Sign::negative : Sign::zero;
}

}  // namespace

Nonvanishing::Nonvanishing(Workshop& workshop, const Equations& stated)
    : workshop_(&workshop), stated_(&stated) {
  for (std::vector<double> point :
       sample(stated.factors, stated.unbounded.size(), most_samples)) {
    point.resize(point.size() + stated.functions.size(), 0.0);
    const auto first = static_cast<std::size_t>(stated.first_function());
    for (std::size_t k = 0; k < stated.functions.size(); ++k)
      point[first + k] =
          std::pow(about(stated.radicands[k], point), 1.0 / stated.functions[k]->degree);
    if (std::ranges::none_of(point, [](double x) { return std::isnan(x); }))
      samples_.push_back(std::move(point));
  }
}

std::optional<Nonvanishing::Trees> Nonvanishing::show(const Polynomial& f, Relation relation,
                                                      const Conditions& conditions) {
  const auto same = [&](const Known& known) {
    return known.relation == relation && known.f == f &&
           std::ranges::equal(known.conditions, conditions, [](const auto& a, const auto& b) {
             return a.relation == b.relation && a.formula == b.formula;
           });
  };
  const auto found = std::ranges::find_if(known_, same);
  if (found != known_.end()) return found->trees;
  std::optional<Trees> trees;
  if (may_hold(f, relation, conditions)) trees = search(f, relation, conditions);
  known_.push_back({f, relation, conditions, trees});
  return trees;
}

bool Nonvanishing::may_hold(const Polynomial& f, Relation relation,
                            const Conditions& conditions) const {
  if (f.is_zero()) return holds(relation, Sign::zero);
  bool above = false, below = false;
  for (const auto& point : samples_) {
    if (!std::ranges::all_of(conditions, [&](const Condition& c) {
          return holds(c.relation, sign_of(about(c.formula, point)));
        }))
      continue;
    const Sign sign = sign_of(about(f, point));
    above = above || sign == Sign::positive;
    below = below || sign == Sign::negative;
  }
  if (relation == Relation::nonzero) return !above || !below;
  return (!above || holds(relation, Sign::positive)) &&
         (!below || holds(relation, Sign::negative));
}

std::optional<Nonvanishing::Trees> Nonvanishing::search(const Polynomial& f, Relation relation,
                                                        const Conditions& conditions) const {
  const auto offset = variables(stated_->factors).size();
  std::vector<std::string> halved;
  for (std::size_t i = 0; i < stated_->unbounded.size(); ++i)
    if (f.degree(static_cast<int>(offset + i)) > 0) halved.push_back(stated_->unbounded[i]);
  if (halved.size() > most_halved) return std::nullopt;
  const exact::RingPtr numbers = exact::Ring::make(f.ring().tower(), {});
  Trees trees;
  for (unsigned sides = 0; sides < 1U << halved.size(); ++sides) {
    Factors factors = stated_->factors;
    for (std::size_t j = 0; j < halved.size(); ++j) {
      const auto entry = [&](long value) { return numbers->constant(value); };
      const long direction = (sides >> j & 1U) != 0 ? 1 : -1;
      factors.push_back({{halved[j]},
                         {{entry(1), entry(0)}, {entry(0), entry(direction)}},
                         {false, false},
                         2U});
    }
    std::optional<SignProof> tree;
    if (stated_->functions.empty())
      tree = search(f, relation, conditions, factors);
    else
      tree = derive(f, relation, conditions, factors);
    if (!tree) return std::nullopt;
    trees.push_back(std::move(*tree));
  }
  return trees;
}

// Whether it holds variables of these factors and functions alone.
bool Nonvanishing::is_covered(const Polynomial& g, const Factors& factors) const {
  const std::vector<std::string> names = variables(factors);
  const auto& all = g.ring().variables();
  for (int i = 0; i < stated_->first_function(); ++i)
    if (g.degree(i) > 0 && !std::ranges::count(names, all[i])) return false;
  return true;
}

std::optional<SignProof> Nonvanishing::derive(const Polynomial& f, Relation relation,
                                              const Conditions& conditions,
                                              const Factors& factors) const {
  Region region = make_region(*workshop_, factors, {}, stated_->functions);
  const exact::RingPtr ring = prove::ring(*workshop_, region);
  Conditions given;
  for (const auto& condition : conditions)
    if (is_covered(condition.formula, factors))
      given.push_back({ring->embed(condition.formula), condition.relation});
  region.where.insert(region.where.begin(), given.begin(), given.end());
  return Derivation(*workshop_, std::move(region)).show(ring->embed(f), relation);
}

std::optional<Pieces> Nonvanishing::search(const Polynomial& f, Relation relation,
                                           const Conditions& conditions,
                                           const Factors& factors) const {
  const std::vector<std::string> names = variables(factors);
  const exact::RingPtr ring = exact::Ring::make(f.ring().tower(), names);
  Question question{factors, ring->embed(f), holds(relation, Sign::zero) == false, {}};
  for (const auto& condition : conditions)
    if (is_covered(condition.formula, factors))
      question.where.push_back({ring->embed(condition.formula), condition.relation});
  for (const int side : {1, -1}) {
    const Relation shown = side > 0 ? Relation::positive : Relation::negative;
    if (!holds(relation, side > 0 ? Sign::positive : Sign::negative)) continue;
    Question asked = question;
    if (side < 0) asked.f = -asked.f;
    Subdivision subdivision(*workshop_, asked, {});
    if (subdivision.run(std::min(most_pieces, workshop_->budget().effort)) ==
        Subdivision::Outcome::proved)
      return Pieces{subdivision.steps(), shown};
  }
  return std::nullopt;
}

}  // namespace seam::prove
