// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "check/tower.h"

#include <algorithm>
#include <array>
#include <utility>

#include "check/elementary.h"

// Why an accepted generator is one number.
//
//   The polynomial f has strict and opposite signs at low and high: there is a root in
//   [low, high]. `isolate` cuts an interval around [low, high] and keeps the parts on
//   which f may vanish, so that all roots lie in their hull; and it answers with the
//   hull only when f' vanishes nowhere on it: there is at most one. On a part X around m
//   the values of f lie in f(m) + f'(X) (X - m).
//
// Why enclosures may be refined by Newton's step.
//
//   For the root r and any m in X, f(m) = f'(s) (m - r) for some s in X, so r lies in
//   m - f(m) / f'(X) if f'(X) does not hold 0.
//
// Values of elementary functions have no rule: a normal form 0 still means 0, whatever else may
// be true of them. But sin(a)^2 = 1 - cos(a)^2 is a rule, where cos(a) comes before sin(a).
//
// Why it ends. Each round of `isolate` halves the widest part, down to one unit; each
// step of Newton halves the width or is the last; there are four precisions.

namespace seam::check {
namespace {

using certificate::Elementary;

constexpr std::array<int, 4> precisions = {64, 256, 1024, 4096};
constexpr std::array<int, 3> isolating_precisions = {64, 256, 1024};
constexpr std::size_t most_parts = 1024;

using Coefficients = std::map<int, Interval>;

// For the four products of ends.
void pay(Meter& meter, const Interval& a, const Interval& b) {
  const std::size_t left = std::max(limbs(a.low), limbs(a.high));
  const std::size_t right = std::max(limbs(b.low), limbs(b.high));
  demand(64 * (left + right) <= Meter::max_bits, "effort");
  meter.charge(4 * left * right);
}

Coefficients derivative(const Coefficients& polynomial) {
  Coefficients result;
  for (const auto& [e, coefficient] : polynomial)
    if (e > 0) result.emplace(e - 1, scaled(coefficient, e));
  return result;
}

// [low, high], rounded outward.
Interval around(const Polynomial& low, const Polynomial& high, int bits) {
  const auto numerator = [](const Polynomial& p) {
    return p.is_zero() ? Integer(0) : p.terms.begin()->second;
  };
  return {floor_quotient(numerator(low) << bits, low.denominator),
          ceiling_quotient(numerator(high) << bits, high.denominator)};
}

// One point about half-way.
Interval middle_of(const Interval& x) {
  const Integer middle = x.low + x.width() / 2;
  return {middle, middle};
}

std::vector<Interval> halves(const std::vector<Interval>& parts) {
  std::vector<Interval> result;
  for (const Interval& part : parts) {
    const Interval middle = middle_of(part);
    result.push_back({part.low, middle.low});
    result.push_back({middle.low, part.high});
  }
  return result;
}

}  // namespace

void Tower::extend(const Polynomial& polynomial, const Polynomial& low,
                   const Polynomial& high) {
  const int index = size();
  demand(polynomial.is_within(index + 1), "degenerate: a number is defined by a later one");
  const Polynomial reduced = ring_->reduce(polynomial);
  demand(sign(ring_->difference(high, low)) > 0, "degenerate: an interval is empty");
  const int at_low = sign(ring_->substitute(reduced, index, low));
  const int at_high = sign(ring_->substitute(reduced, index, high));
  demand(at_low * at_high < 0, "degenerate: no change of sign between the ends of an interval");

  auto coefficients = by_exponent(reduced, index, ring_->meter());
  for (auto& [e, coefficient] : coefficients) coefficient.denominator = 1;
  for (const int bits : isolating_precisions) {
    const auto start = isolate(enclose(coefficients, bits), around(low, high, bits), bits);
    if (!start) continue;
    generators_.push_back({std::move(coefficients), *start, bits});
    ring_->add_rule(index, reduced);
    return;
  }
  throw Open("degenerate: an interval was not seen to hold one simple root alone");
}

void Tower::extend(Elementary function, const Polynomial& argument) {
  const int index = size();
  demand(argument.is_within(index), "degenerate: a number is defined by a later one");
  Generator generator{{}, {}, 0, function, ring_->reduce(argument)};
  if (function == Elementary::log) {
    demand(sign(argument) > 0, "degenerate: a logarithm of a number that is not positive");
    const auto is_seen = [&](int bits) { return enclose(generator.argument, bits).low > 0; };
    generator.start_bits = *std::ranges::find_if(precisions, is_seen);
  }
  if (function == Elementary::sin)
    for (int i = 0; i < index; ++i)
      if (const Generator& other = generators_[static_cast<std::size_t>(i)];
          other.function == Elementary::cos &&
          ring_->difference(other.argument, generator.argument).is_zero()) {
        Polynomial circle = ring_->sum(symbol(index, 2), constant(-1));
        ring_->add_rule(index, ring_->sum(std::move(circle), ring_->power(symbol(i), 2)));
        break;
      }
  generators_.push_back(std::move(generator));
}

bool Tower::is_value(Elementary function, const Polynomial& argument, const Polynomial& value) {
  const auto equal = [this](const Polynomial& a, const Polynomial& b) {
    return find_sign(ring_->difference(a, b)) == 0;
  };
  const Polynomial nil = constant(0), one = constant(1);
  const bool is_log = function == Elementary::log;
  if (equal(argument, is_log ? one : nil))
    return equal(value, is_log || function == Elementary::sin ? nil : one);
  for (int i = 0; i < size(); ++i) {
    const Generator& known = generators_[static_cast<std::size_t>(i)];
    if (known.function == function && equal(known.argument, argument) &&
        equal(value, symbol(i)))
      return true;
  }
  return false;
}

std::optional<int> Tower::find_sign(const Polynomial& number) {
  const Polynomial reduced = ring_->reduce(number);
  demand(reduced.is_within(size()), "malformed: a variable where a number is needed");
  if (reduced.is_zero()) return 0;
  if (reduced.is_rational()) return reduced.terms.begin()->second > 0 ? 1 : -1;
  for (const int bits : precisions) {
    const Interval values = enclose(reduced, bits);
    if (!values.holds_zero()) return values.low > 0 ? 1 : -1;
  }
  return std::nullopt;
}

int Tower::sign(const Polynomial& number) {
  const auto found = find_sign(number);
  demand(found.has_value(), "effort: a sign could not be decided");
  return *found;
}

// Of the numerator: the denominator is positive and does not change the sign.
Interval Tower::enclose(const Polynomial& number, int bits) {
  ring_->meter().charge(words(number));
  Interval total{0, 0};
  for (const auto& [monomial, coefficient] : number.terms) {
    Interval term{Integer(1) << bits, Integer(1) << bits};
    for (int i = 0; i < std::ssize(monomial); ++i)
      if (const int e = exponent(monomial, i); e > 0) {
        const Interval& factor = generator_power(i, e, bits);
        pay(ring_->meter(), term, factor);
        term = product(term, factor, bits);
      }
    total = sum(total, scaled(term, coefficient));
  }
  return total;
}

Coefficients Tower::enclose(const std::map<int, Polynomial>& numbers, int bits) {
  Coefficients result;
  for (const auto& [e, number] : numbers) result.emplace(e, enclose(number, bits));
  return result;
}

Interval Tower::value(const Coefficients& polynomial, const Interval& x, int bits) {
  Interval result{0, 0};
  if (polynomial.empty()) return result;
  for (int e = polynomial.rbegin()->first; e >= 0; --e) {
    pay(ring_->meter(), result, x);
    result = product(result, x, bits);
    if (const auto found = polynomial.find(e); found != polynomial.end())
      result = sum(result, found->second);
  }
  return result;
}

std::optional<Interval> Tower::isolate(const Coefficients& polynomial, const Interval& within,
                                       int bits) {
  const Coefficients slope = derivative(polynomial);
  std::vector<Interval> parts = {within};
  for (Integer width = within.width(); width > 0; width /= 2) {
    std::erase_if(parts, [&](const Interval& part) {
      const Interval middle = middle_of(part);
      const Interval offset{part.low - middle.low, part.high - middle.low};
      const Interval change = product(value(slope, part, bits), offset, bits);
      return !sum(value(polynomial, middle, bits), change).holds_zero();
    });
    if (parts.empty() || parts.size() > most_parts) return std::nullopt;
    const Interval hull{parts.front().low, parts.back().high};
    if (!value(slope, hull, bits).holds_zero()) return hull;
    parts = halves(parts);
  }
  return std::nullopt;
}

Interval Tower::value(Elementary function, const Polynomial& argument, int bits) {
  const Interval numerator = enclose(argument, bits);
  const Interval x{floor_quotient(numerator.low, argument.denominator),
                   ceiling_quotient(numerator.high, argument.denominator)};
  return elementary(function, x, bits, ring_->meter());
}

Interval Tower::refined(const Generator& generator, int bits) {
  if (generator.function != Elementary::none) {
    const int fine = std::max(bits, generator.start_bits);
    return rescaled(value(generator.function, generator.argument, fine), fine, bits);
  }
  const Coefficients polynomial = enclose(generator.coefficients, bits);
  const Coefficients slope = derivative(polynomial);
  Interval x = rescaled(generator.start, generator.start_bits, bits);
  for (;;) {
    const Interval slopes = value(slope, x, bits);
    if (slopes.holds_zero()) return x;
    const Interval middle = middle_of(x);
    const Interval step = quotient(value(polynomial, middle, bits), slopes, bits);
    const Interval next{std::max(x.low, middle.low - step.high),
                        std::min(x.high, middle.low - step.low)};
    const bool last = 2 * next.width() > x.width() || next.width() == 0;
    x = next;
    if (last) return x;
  }
}

const Interval& Tower::generator_power(int index, int e, int bits) {
  std::vector<Powers>& known = enclosures_[bits];
  while (std::ssize(known) <= index) {
    const Interval x = refined(generators_[known.size()], bits);
    known.push_back({{Integer(1) << bits, Integer(1) << bits}, x});
  }
  Powers& powers = known[static_cast<std::size_t>(index)];
  while (std::ssize(powers) <= e) {
    pay(ring_->meter(), powers.back(), powers[1]);
    powers.push_back(product(powers.back(), powers[1], bits));
  }
  return powers[static_cast<std::size_t>(e)];
}

}  // namespace seam::check
