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

using certificate::Elementary;
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

// Not finite where the function has no value.
double about(const certificate::Function& function, double operand) {
  switch (function.elementary) {
    case Elementary::exp:
      return std::exp(operand);
    case Elementary::log:
      return operand > tolerance ? std::log(operand) : std::nan("");
    case Elementary::sin:
      return std::sin(operand);
    case Elementary::cos:
      return std::cos(operand);
    default:
      return operand > -tolerance ? std::pow(std::max(0.0, operand), 1.0 / function.degree)
                                  : std::nan("");
  }
}

// Values at a point, in the order of the names: near what they are, if not exact.
class Values {
 public:
  Values(Workshop& workshop, std::vector<std::string> names, bool is_near)
      : workshop_(workshop), names_(std::move(names)), is_near_(is_near) {}

  void add(const Polynomial& value) { values_.push_back({value, Elementary::none, value}); }

  // Of the next function. Nothing is added where it has no value, or it takes a new number that
  // may not be added.
  bool add(const certificate::Function& function, bool may_adjoin) {
    if (function.is_root()) {
      const Polynomial operand = at(function.operand);
      if (exact::sign(operand) == Sign::negative) return false;
      const auto value = root(workshop_, operand, function.degree, may_adjoin);
      if (value) add(*value);
      return value.has_value();
    }
    const auto operand = exactly(function.operand);
    if (!operand) return false;
    const auto near = workshop_.near_value(function.elementary, *operand);
    if (near) values_.push_back({*near, function.elementary, *operand});
    return near.has_value();
  }

  Sign sign(const Polynomial& f) const {
    const Polynomial value = place(f);
    if (is_near_ && std::abs(exact::ball(value).middle) < negligible) return Sign::zero;
    return exact::sign(value);
  }

  certificate::Point point() const {
    certificate::Point result{names_, {}};
    for (const auto& [near, function, operand] : values_)
      result.values.push_back(function == Elementary::none
                                  ? workshop_.write(near)
                                  : workshop_.write(function, operand));
    return result;
  }

 private:
  struct Value {
    Polynomial near;
    Elementary function;  // none: `near` is the value
    Polynomial operand;
    bool is_exact() const {
      return function == Elementary::none || Workshop::is_simple(function, operand);
    }
  };
  static constexpr double negligible = 1e-25;

  Polynomial place(const Polynomial& f) const {
    const RingPtr numbers = workshop_.numbers();
    std::vector<Polynomial> here;
    for (const Value& value : values_) here.push_back(numbers->embed(value.near));
    here.resize(names_.size(), numbers->constant(0));
    return workshop_.ring(names_)->embed(f).substitute(numbers, here);
  }
  Polynomial at(certificate::Term term) const { return place(workshop_.expand(term, names_)); }

  // In transcendental numbers; nothing if it holds a function of which only a number near it is
  // known.
  std::optional<Polynomial> exactly(certificate::Term term) const {
    const auto& numbers = workshop_.transcendental();
    std::vector<std::string> all = names_;
    all.insert(all.end(), numbers.begin(), numbers.end());
    const Polynomial f = workshop_.expand(term, all);
    for (std::size_t i = 0; i < values_.size(); ++i)
      if (!values_[i].is_exact() && f.degree(static_cast<int>(i)) > 0) return std::nullopt;
    const RingPtr ring = workshop_.ring(numbers);
    std::vector<Polynomial> here;
    for (const Value& value : values_) here.push_back(ring->embed(value.near));
    here.resize(names_.size(), ring->constant(0));
    for (std::size_t i = 0; i < numbers.size(); ++i)
      here.push_back(ring->variable(static_cast<int>(i)));
    return f.substitute(ring, here);
  }

  Workshop& workshop_;
  std::vector<std::string> names_;
  bool is_near_;
  std::vector<Value> values_;
};

}  // namespace

std::vector<Sample> samples(Workshop& workshop, const Region& region) {
  using bernstein::Sketch;
  const RingPtr all = ring(workshop, region);
  std::vector<Sketch> operands, conditions;
  for (const auto* function : region.functions)
    operands.emplace_back(workshop.expand(function->operand, all->variables()));
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
    for (std::size_t i = 0; inside && i < operands.size(); ++i) {
      const double value = about(*region.functions[i], operands[i].jet(values).value);
      inside = std::isfinite(value);
      values[variables + i] = value;
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
  Values values(workshop, variables(region.factors),
                region.is_elementary() || !workshop.transcendental().empty());
  for (std::size_t k = 0; k < place.size(); ++k)
    for (const Polynomial& x : point(region.factors[k], place[k])) values.add(x);
  for (const auto* function : region.functions)
    if (!values.add(*function, may_adjoin)) return std::nullopt;
  for (const auto& [formula, condition] : region.where)
    if (!holds(condition, values.sign(formula))) return std::nullopt;
  if (holds(relation, values.sign(f))) return std::nullopt;
  return values.point();
}

}  // namespace seam::prove
