// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "check/polynomial.h"

#include <algorithm>
#include <utility>

// Schoolbook arithmetic on sorted terms. Every loop over terms charges the meter
// for the limbs it multiplies and stops before a value outgrows its limits.

namespace seam::check {
namespace {

std::size_t bits(const Integer& n) {
  return n == 0 ? 0 : msb(abs(n)) + 1;
}
std::size_t max_limbs(const Polynomial& p) {
  std::size_t most = 1;
  for (const auto& [monomial, coefficient] : p.terms) most = std::max(most, limbs(coefficient));
  return most;
}

Monomial joined(const Monomial& a, const Monomial& b) {
  const Monomial& shorter = a.size() < b.size() ? a : b;
  Monomial product = a.size() < b.size() ? b : a;
  for (std::size_t i = 0; i < shorter.size(); ++i) {
    const int sum = product[i] + shorter[i];
    demand(sum <= Meter::max_exponent, "effort");
    product[i] = static_cast<char16_t>(sum);
  }
  return product;
}

void trim(Monomial& monomial) {
  while (!monomial.empty() && monomial.back() == 0) monomial.pop_back();
}

void add_term(Polynomial& to, Monomial monomial, const Integer& coefficient) {
  if (coefficient == 0) return;
  const auto [place, is_new] = to.terms.try_emplace(std::move(monomial));
  place->second += coefficient;
  if (place->second == 0) to.terms.erase(place);
}

// Takes out what numerator and denominator have in common.
void cancel(Polynomial& p, Meter& meter) {
  if (p.denominator == 1) return;
  Integer common = p.denominator;
  for (const auto& [monomial, coefficient] : p.terms) {
    if (common == 1) return;
    meter.charge(limbs(common) * limbs(coefficient));
    common = gcd(common, coefficient);
  }
  for (auto& [monomial, coefficient] : p.terms) {
    meter.charge(limbs(common) * limbs(coefficient));
    coefficient /= common;
  }
  p.denominator /= common;
}

}  // namespace

std::size_t limbs(const Integer& n) {
  return 1 + bits(n) / 64;
}

bool Polynomial::is_within(int count) const {
  return std::ranges::all_of(terms, [count](const auto& term) {
    return std::cmp_less_equal(term.first.size(), count);
  });
}

Polynomial constant(const Integer& numerator, const Integer& denominator) {
  Polynomial p;
  if (numerator == 0) return p;
  p.terms.emplace(Monomial(), numerator);
  p.denominator = denominator;
  return p;
}

Polynomial symbol(int index, int exponent) {
  demand(exponent <= Meter::max_exponent, "effort");
  Polynomial p;
  Monomial monomial(static_cast<std::size_t>(index), u'\0');
  monomial.push_back(static_cast<char16_t>(exponent));
  p.terms.emplace(std::move(monomial), 1);
  return p;
}

// Boost reads a leading 0 as octal: the form of the text, checked before, excludes it.
Polynomial parse_rational(const std::string& text, Meter& meter) {
  meter.charge(text.size() * text.size() / 64);
  const std::size_t slash = text.find('/');
  const Integer numerator(text.substr(0, slash));
  const Integer denominator(slash == std::string::npos ? "1" : text.substr(slash + 1));
  demand(denominator > 0, "malformed: a denominator that is not positive");
  Polynomial p = constant(numerator, denominator);
  cancel(p, meter);
  return p;
}

int exponent(const Monomial& monomial, int index) {
  const auto place = static_cast<std::size_t>(index);
  return place < monomial.size() ? monomial[place] : 0;
}

int degree(const Polynomial& p, int index) {
  int highest = -1;
  for (const auto& [monomial, coefficient] : p.terms)
    highest = std::max(highest, exponent(monomial, index));
  return highest;
}

std::size_t words(const Polynomial& p) {
  std::size_t sum = 8;
  for (const auto& [monomial, coefficient] : p.terms)
    sum += 12 + monomial.size() / 4 + limbs(coefficient);
  return sum;
}

Polynomial negated(Polynomial p) {
  for (auto& [monomial, coefficient] : p.terms) coefficient = -coefficient;
  return p;
}

void add(Polynomial& to, const Polynomial& p, Meter& meter) {
  if (p.is_zero()) return;
  const bool same = to.denominator == p.denominator;
  if (!same) meter.charge(limbs(to.denominator) * limbs(p.denominator));
  const Integer common = same ? to.denominator : lcm(to.denominator, p.denominator);
  const Integer mine = common / to.denominator;
  const Integer theirs = common / p.denominator;
  demand(bits(common) <= Meter::max_bits, "effort");
  if (mine != 1)
    for (auto& [monomial, coefficient] : to.terms) {
      meter.charge(limbs(coefficient) * limbs(mine));
      demand(bits(coefficient) + bits(mine) <= Meter::max_bits, "effort");
      coefficient *= mine;
    }
  to.denominator = common;
  const std::size_t each = max_limbs(p) + limbs(theirs) + 12;
  for (const auto& [monomial, coefficient] : p.terms) {
    meter.charge(limbs(coefficient) * limbs(theirs) + monomial.size() / 8);
    demand(64 * each <= Meter::max_bits, "effort");
    demand((to.terms.size() + 1) * (each + monomial.size() / 4) <= Meter::max_words, "effort");
    add_term(to, monomial, same ? coefficient : coefficient * theirs);
  }
  if (!same) cancel(to, meter);
}

Polynomial multiply(const Polynomial& a, const Polynomial& b, Meter& meter) {
  const std::size_t below_a = limbs(a.denominator);
  const std::size_t below_b = limbs(b.denominator);
  const std::size_t each = max_limbs(a) + max_limbs(b) + 12;
  demand(64 * std::max(each, below_a + below_b) <= Meter::max_bits, "effort");
  meter.charge(below_a * below_b);
  Polynomial product;
  product.denominator = a.denominator * b.denominator;
  for (const auto& [left, x] : a.terms)
    for (const auto& [right, y] : b.terms) {
      const std::size_t length = std::max(left.size(), right.size());
      meter.charge(limbs(x) * limbs(y) + length / 8);
      demand((product.terms.size() + 1) * (each + length / 4) <= Meter::max_words, "effort");
      add_term(product, joined(left, right), x * y);
    }
  cancel(product, meter);
  return product;
}

Polynomial derivative(const Polynomial& p, int index, Meter& meter) {
  Polynomial result;
  result.denominator = p.denominator;
  for (const auto& [monomial, coefficient] : p.terms) {
    const int e = exponent(monomial, index);
    meter.charge(limbs(coefficient));
    if (e == 0) continue;
    Monomial lower = monomial;
    lower[static_cast<std::size_t>(index)] = static_cast<char16_t>(e - 1);
    trim(lower);
    add_term(result, std::move(lower), coefficient * e);
  }
  return result;
}

std::map<int, Polynomial> by_exponent(const Polynomial& p, int index, Meter& meter) {
  std::map<int, Polynomial> parts;
  for (const auto& [monomial, coefficient] : p.terms) {
    meter.charge(limbs(coefficient) + monomial.size() / 8);
    const int e = exponent(monomial, index);
    Monomial rest = monomial;
    if (e > 0) rest[static_cast<std::size_t>(index)] = 0;
    trim(rest);
    Polynomial& part = parts[e];
    part.denominator = p.denominator;
    part.terms.emplace(std::move(rest), coefficient);
  }
  return parts;
}

std::map<Monomial, Polynomial> by_monomial(const Polynomial& p, int first, Meter& meter) {
  std::map<Monomial, Polynomial> parts;
  for (const auto& [monomial, coefficient] : p.terms) {
    meter.charge(limbs(coefficient) + monomial.size() / 8);
    const std::size_t split = std::min(monomial.size(), static_cast<std::size_t>(first));
    Monomial below = monomial.substr(0, split);
    trim(below);
    Monomial above = monomial;
    std::fill_n(above.begin(), split, u'\0');
    trim(above);
    Polynomial& part = parts[above];
    part.denominator = p.denominator;
    part.terms.emplace(std::move(below), coefficient);
  }
  return parts;
}

}  // namespace seam::check
