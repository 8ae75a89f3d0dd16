// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/scalar.h"

#include <algorithm>
#include <cstdlib>
#include <unordered_map>

// Divisors only ever accumulate: an operation has the divisors of its operands, and a
// quotient also what it divides by. So a value that the text leaves undefined
// somewhere can never look defined there after cancellation.

namespace seam::claims {
namespace {

void add_divisor(std::vector<Formula>& divisors, const Formula& divisor) {
  const bool known = std::ranges::any_of(
      divisors, [&](const Formula& d) { return d.identity() == divisor.identity(); });
  if (!known) divisors.push_back(divisor);
}

std::vector<Formula> united(const Scalar& a, const Scalar& b) {
  std::vector<Formula> all = a.divisors;
  for (const Formula& divisor : b.divisors) add_divisor(all, divisor);
  return all;
}

bool same_denominator(const Scalar& a, const Scalar& b) {
  return a.denominator.identity() == b.denominator.identity() ||
         (a.denominator.is(1) && b.denominator.is(1));
}

Scalar with(Formula numerator, Formula denominator, std::vector<Formula> divisors) {
  Scalar result(std::move(numerator));
  result.denominator = std::move(denominator);
  result.divisors = std::move(divisors);
  return result;
}

}  // namespace

Scalar operator+(const Scalar& a, const Scalar& b) {
  if (same_denominator(a, b))
    return with(a.numerator + b.numerator, a.denominator, united(a, b));
  return with(a.numerator * b.denominator + b.numerator * a.denominator,
              a.denominator * b.denominator, united(a, b));
}

Scalar operator-(const Scalar& a) {
  return with(-a.numerator, a.denominator, a.divisors);
}
Scalar operator-(const Scalar& a, const Scalar& b) {
  if (same_denominator(a, b))
    return with(a.numerator - b.numerator, a.denominator, united(a, b));
  return a + -b;
}

Scalar operator*(const Scalar& a, const Scalar& b) {
  return with(a.numerator * b.numerator, a.denominator * b.denominator, united(a, b));
}

Scalar divide(const Scalar& a, const Scalar& b, Numbers& numbers) {
  const Formula& divisor = b.numerator;
  if (symbolic::is_number(divisor)) {
    if (divisor.is_constant() && divisor.value() == 0) throw DivisionByZero();
    if (!divisor.is_constant() && numbers.sign(divisor) == exact::Sign::zero)
      throw DivisionByZero();
    const Formula inverse = divisor.is_constant()
                                ? Formula(exact::Rational(1) / divisor.value())
                                : numbers.inverse(divisor);
    return with(a.numerator * b.denominator * inverse, a.denominator, united(a, b));
  }
  Scalar result = with(a.numerator * b.denominator, a.denominator * divisor, united(a, b));
  add_divisor(result.divisors, divisor);
  return result;
}

Scalar power(const Scalar& base, long exponent, Numbers& numbers) {
  if (std::labs(exponent) > 1000)
    throw symbolic::NumberError("an exponent of more than 1000 is too large");
  if (exponent < 0) return divide(Scalar(1), power(base, -exponent, numbers), numbers);
  const int n = static_cast<int>(exponent);
  return with(symbolic::power(base.numerator, n), symbolic::power(base.denominator, n),
              base.divisors);
}

namespace {

using Memo = std::unordered_map<const void*, Scalar>;

Scalar walk(const Formula& f, const std::map<std::string, Scalar>& map, Memo& memo,
            Numbers& numbers) {
  if (f.kind() == Formula::Kind::constant || f.kind() == Formula::Kind::known) return {f};
  if (f.kind() == Formula::Kind::symbol) {
    const auto found = map.find(f.name());
    return found == map.end() ? Scalar(f) : found->second;
  }
  if (const auto found = memo.find(f.identity()); found != memo.end()) return found->second;
  Scalar result;
  if (f.kind() == Formula::Kind::power) {
    result = power(walk(f.operands()[0], map, memo, numbers), f.exponent(), numbers);
  } else {
    const bool is_sum = f.kind() == Formula::Kind::sum;
    result = Scalar(is_sum ? 0 : 1);
    for (const Formula& operand : f.operands()) {
      const Scalar next = walk(operand, map, memo, numbers);
      result = is_sum ? result + next : result * next;
    }
  }
  memo.emplace(f.identity(), result);
  return result;
}

}  // namespace

Scalar substitute(const Scalar& value, const std::map<std::string, Scalar>& map,
                  Numbers& numbers) {
  const bool polynomial =
      std::ranges::all_of(map, [](const auto& entry) { return entry.second.is_polynomial(); });
  if (polynomial) {
    std::map<std::string, Formula> formulas;
    for (const auto& [name, scalar] : map) formulas.emplace(name, scalar.numerator);
    Scalar result(symbolic::subst(value.numerator, formulas));
    for (const Formula& divisor : value.divisors) {
      const Formula replaced = symbolic::subst(divisor, formulas);
      if (symbolic::is_number(replaced) && numbers.sign(replaced) == exact::Sign::zero)
        throw DivisionByZero();
      if (!symbolic::is_number(replaced)) add_divisor(result.divisors, replaced);
    }
    Scalar below(symbolic::subst(value.denominator, formulas));
    if (below.numerator.is(1)) return result;
    Scalar quotient = divide(Scalar(result.numerator), below, numbers);
    for (const Formula& divisor : result.divisors) add_divisor(quotient.divisors, divisor);
    return quotient;
  }
  Memo memo;
  Scalar result = divide(walk(value.numerator, map, memo, numbers),
                         walk(value.denominator, map, memo, numbers), numbers);
  for (const Formula& divisor : value.divisors) {
    const Scalar replaced = divide(Scalar(1), walk(divisor, map, memo, numbers), numbers);
    for (const Formula& d : replaced.divisors) add_divisor(result.divisors, d);
  }
  return result;
}

bool is_number(const Scalar& value) {
  return value.is_polynomial() && symbolic::is_number(value.numerator);
}

}  // namespace seam::claims
