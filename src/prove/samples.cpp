// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/samples.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "bernstein/critical.h"
#include "exact/roots.h"
#include "prove/linear.h"

// Search only: `witness` evaluates exactly. Among the numbers tried are the sides of small
// right-angled triangles, at which sqrt(1 - x^2) is rational.

namespace seam::prove {

using exact::Integer;
using exact::Polynomial;
using exact::Rational;
using exact::RingPtr;
using exact::Sign;

namespace {

constexpr std::size_t most_samples = 3000;
constexpr std::size_t most_places = 60;  // of one factor
constexpr double tolerance = 1e-9;

// A place in one factor.
using Local = std::vector<Polynomial>;

constexpr std::array<const char*, 34> simple_numbers = {
    "3/5",    "4/5",   "0",     "1",     "1/2", "5/13", "12/13", "8/17", "15/17",
    "7/25",   "24/25", "20/29", "21/29", "1/3", "2/3",  "1/4",   "3/4",  "2",
    "3/2",    "1/10",  "9/10",  "1/100", "3",   "5/4",  "5/3",   "13/5", "10",
    "99/100", "9/41",  "40/41", "11/61", "4",   "5",    "13/12"};

void add_if_inside(std::vector<Local>& places, const Factor& factor, Local l) {
  Corners support = 0;
  for (std::size_t i = 0; i < l.size(); ++i) {
    if (exact::sign(l[i]) == Sign::negative) return;
    if (!l[i].is_zero()) support |= 1U << i;
  }
  if (!is_outside(factor, support) && places.size() < most_places)
    places.push_back(std::move(l));
}

std::vector<Local> places_of(Workshop& workshop, const Factor& factor) {
  const RingPtr ring = workshop.numbers();
  std::vector<Local> places;
  const std::size_t size = factor.corners.size();
  if (size == 2) {
    std::vector<std::vector<Polynomial>> corners;
    for (const auto& corner : factor.corners) {
      corners.emplace_back();
      for (const Polynomial& x : corner) corners.back().push_back(ring->embed(x));
    }
    for (const int side : {1, -1})
      for (const char* number : simple_numbers)
        add_if_inside(
            places, factor,
            barycentric(corners, {ring->constant(1), ring->constant(side * Rational(number))}));
  }
  for (const int most : {1, 2, 3}) {  // all weights up to this one, which occurs
    std::vector<int> weights(size, 0);
    for (;;) {
      std::size_t i = 0;
      while (i < size && ++weights[i] > most) weights[i++] = 0;
      if (i == size) break;
      if (std::ranges::max(weights) != most) continue;
      Local l;
      for (const int w : weights) l.push_back(ring->constant(w));
      add_if_inside(places, factor, std::move(l));
    }
  }
  return places;
}

std::vector<Place> places(Workshop& workshop, const Region& region) {
  std::vector<std::vector<Local>> lists;
  for (std::size_t k = 0; k + region.functions.size() < region.factors.size(); ++k) {
    lists.push_back(places_of(workshop, region.factors[k]));
    if (lists.back().empty()) return {};
  }
  std::vector<Place> result;
  // By rising sum of the indices, so that simple ones come first in all factors.
  std::vector<std::size_t> choice(lists.size(), 0);
  const auto take = [&] {
    Place& place = result.emplace_back();
    for (std::size_t k = 0; k < lists.size(); ++k) place.push_back(lists[k][choice[k]]);
  };
  const auto choose = [&](const auto& self, std::size_t k, std::size_t sum) -> void {
    if (result.size() >= most_samples) return;
    if (k == lists.size()) {
      if (sum == 0) take();
      return;
    }
    for (choice[k] = 0; choice[k] < lists[k].size() && choice[k] <= sum; ++choice[k])
      self(self, k + 1, sum - choice[k]);
  };
  std::size_t most = 0;
  for (const auto& list : lists) most += list.size() - 1;
  for (std::size_t sum = 0; sum <= most && result.size() < most_samples; ++sum)
    choose(choose, 0, sum);
  return result;
}

bool nearly(certificate::Relation relation, double value) {
  const Sign s = std::abs(value) < tolerance ? Sign::zero
                 : value > 0                 ? Sign::positive
                                             : Sign::negative;
  return holds(relation, s);
}

// The n-th root >= 0 of a number >= 0.
std::optional<Polynomial> root(Workshop& workshop, const Polynomial& radicand, int n,
                               bool may_adjoin) {
  const auto numbers = workshop.numbers();
  if (radicand.is_zero()) return radicand;
  if (const auto rational = radicand.rational()) {
    Rational result;
    const auto degree = static_cast<unsigned long>(n);
    if (mpz_root(result.get_num_mpz_t(), rational->get_num_mpz_t(), degree) != 0 &&
        mpz_root(result.get_den_mpz_t(), rational->get_den_mpz_t(), degree) != 0)
      return numbers->constant(result);
  }
  if (!may_adjoin) return std::nullopt;
  exact::Univariate f(static_cast<std::size_t>(n) + 1, numbers->constant(0));
  f.front() = -radicand;
  f.back() = numbers->constant(1);
  return workshop.adjoin(f, exact::real_roots(f).back());
}

}  // namespace

std::vector<Sample> samples(Workshop& workshop, const Region& region) {
  using bernstein::Sketch;
  const RingPtr all = ring(workshop, region);
  std::vector<Sketch> radicands, conditions;
  for (const auto* function : region.functions)
    radicands.emplace_back(workshop.expand(function->radicand, all->variables()));
  for (const Condition& condition : region.where) conditions.emplace_back(condition.formula);
  std::vector<Sample> result;
  for (Place& place : places(workshop, region)) {
    std::vector<double> values;
    for (std::size_t k = 0; k < place.size(); ++k)
      for (const Polynomial& x : point(region.factors[k], place[k]))
        values.push_back(exact::ball(x).middle);
    const std::size_t variables = values.size();
    values.resize(all->variables().size(), 0);
    bool inside = true;
    for (std::size_t i = 0; inside && i < radicands.size(); ++i) {
      const double radicand = radicands[i].jet(values).value;
      inside = radicand > -tolerance;
      values[variables + i] =
          std::pow(std::max(0.0, radicand), 1.0 / region.functions[i]->degree);
    }
    for (std::size_t i = 0; inside && i < conditions.size(); ++i)
      inside = nearly(region.where[i].relation, conditions[i].jet(values).value);
    if (inside) result.push_back({std::move(place), std::move(values)});
  }
  return result;
}

std::optional<certificate::Point> witness(Workshop& workshop, const Region& region,
                                          const Polynomial& f, certificate::Relation relation,
                                          const Place& place, bool may_adjoin) {
  const auto names = variables(region.factors);
  std::vector<Polynomial> values;
  for (std::size_t k = 0; k < place.size(); ++k)
    for (const Polynomial& x : point(region.factors[k], place[k])) values.push_back(x);
  const auto sign_of = [&](const Polynomial& g) {
    const RingPtr numbers = workshop.numbers();
    std::vector<Polynomial> here;
    for (const Polynomial& x : values) here.push_back(numbers->embed(x));
    here.resize(names.size(), numbers->constant(0));
    const Polynomial value = workshop.ring(names)->embed(g).substitute(numbers, here);
    return std::pair(exact::sign(value), value);
  };
  for (const auto* function : region.functions) {
    const auto [sign, radicand] = sign_of(workshop.expand(function->radicand, names));
    if (sign == Sign::negative) return std::nullopt;
    const auto value = root(workshop, radicand, function->degree, may_adjoin);
    if (!value) return std::nullopt;
    values.push_back(*value);
  }
  for (const auto& [formula, condition] : region.where)
    if (!holds(condition, sign_of(formula).first)) return std::nullopt;
  if (holds(relation, sign_of(f).first)) return std::nullopt;
  certificate::Point result;
  result.variables = names;
  for (const Polynomial& value : values) result.values.push_back(workshop.write(value));
  return result;
}

}  // namespace seam::prove
