// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/elementary.h"

#include <cstdlib>

#include "claims/angles.h"
#include "symbolic/coefficients.h"
#include "symbolic/denominator.h"

// The operand is a sum of terms p/q m, m a product of variables, numbers and other functions
// without a rational factor. exp(p/q m) = exp(m/q)^p; cos and sin of it come from those of m/q
// by powers of cos + i sin, and those of the sum by the theorems of addition. Rational
// multiples of pi have algebraic cosines. Different q of one m meet where a statement is
// written down.

namespace seam::claims {
namespace {

using exact::Integer;
using exact::Rational;
using symbolic::Factors;
using symbolic::Monomial;

constexpr long most_powers = 1000;
constexpr long most_turns = 12;  // of a number

std::vector<Monomial> terms(const Scalar& x, Numbers& numbers) {
  Factors below;
  Formula numerator = x.numerator;
  for (const auto& [factor, n] : symbolic::factors(x.denominator).powers) {
    if (symbolic::is_number(factor))
      numerator = numerator * symbolic::power(numbers.inverse(factor), n);
    else
      below.powers.emplace_back(factor, n);
  }
  std::vector<Monomial> all = symbolic::monomials(numerator, numbers);
  for (Monomial& term : all) {
    term.coefficient /= symbolic::factors(x.denominator).constant;
    if (!below.powers.empty())
      term.powers = term.powers * symbolic::inverse(symbolic::product(below));
  }
  return all;
}

long small(const Integer& n) {
  if (abs(n) > most_powers)
    throw symbolic::NumberLimit("multiples over 1000 in a function are not covered");
  return n.get_si();
}

// Where x has a value.
Scalar where_defined(Scalar value, const Scalar& x) {
  value.divisors.insert(value.divisors.end(), x.divisors.begin(), x.divisors.end());
  value.radicands.insert(value.radicands.end(), x.radicands.begin(), x.radicands.end());
  return value;
}

// A number, if the operand is one.
Formula value_of(const std::string& function, const Formula& operand, Numbers& numbers) {
  return symbolic::is_number(operand) ? numbers.elementary(function, operand)
                                      : Formula::applied(function, {operand});
}

// The operand, if f is a value of this function.
std::optional<Formula> inside(const Formula& f, const std::string& function,
                              const Numbers& numbers) {
  if (f.kind() == Formula::Kind::applied && f.name() == function) return f.operands()[0];
  if (f.kind() != Formula::Kind::symbol) return std::nullopt;
  const auto* generator = numbers.find(f.name());
  if (!generator || generator->function != function) return std::nullopt;
  return generator->argument;
}

Scalar exp(const Scalar& x, Numbers& numbers) {
  Scalar result(1);
  for (const auto& [coefficient, powers] : terms(x, numbers)) {
    const long n = small(coefficient.get_num());
    const Integer& q = coefficient.get_den();
    if (const auto base = inside(powers, "log", numbers); base && q <= 2) {
      const Scalar b = scalar_of(*base, numbers);
      result = result * power(q == 1 ? b : nth_root(b, 2, numbers), n, numbers);
      continue;
    }
    const Formula unit = symbolic::power(value_of("exp", divided(powers, q), numbers),
                                         static_cast<int>(std::labs(n)));
    Scalar factor(n > 0 ? unit : Formula(1));
    if (n < 0) factor.denominator = unit;
    result = result * factor;
  }
  return where_defined(result, x);
}

Turn turn(const Scalar& x, Numbers& numbers) {
  Turn result{1, 0};
  for (const auto& [coefficient, powers] : terms(x, numbers)) {
    if (powers.same(numbers.pi())) {
      const Rational rest = Rational(1, 2) - coefficient;
      result =
          together(result, {numbers.cosine_of_pi(coefficient), numbers.cosine_of_pi(rest)});
      continue;
    }
    const Integer& times = coefficient.get_num();
    if (symbolic::is_number(powers) && abs(times) > most_turns) {
      const Formula whole = Formula(coefficient) * powers;
      result = together(result,
                        {numbers.elementary("cos", whole), numbers.elementary("sin", whole)});
      continue;
    }
    const Formula operand = divided(powers, coefficient.get_den());
    const Turn unit{value_of("cos", operand, numbers), value_of("sin", operand, numbers)};
    result = together(result, multiple(unit, small(times)));
  }
  return result;
}

// Of a rational > 0: by its prime factors, as far as they are small.
Formula log_of_rational(const Rational& x, Numbers& numbers) {
  constexpr long bound = 100'000;
  Formula sum = 0;
  for (const int side : {1, -1}) {
    Integer rest = side > 0 ? x.get_num() : x.get_den();
    const auto add = [&](const Integer& prime, long count) {
      if (count > 0)
        sum += Formula(side * count) * numbers.elementary("log", Formula(Rational(prime)));
    };
    for (long p = 2; p < bound && p * p <= rest; p += p == 2 ? 1 : 2) {
      long count = 0;
      for (; rest % p == 0; ++count) rest /= p;
      add(p, count);
    }
    if (rest > 1) add(rest, 1);
  }
  return sum;
}

// Of a number > 0. If a power of it is rational, by the logarithm of that.
Formula log_of_number(const Formula& x, Numbers& numbers) {
  if (const auto rational = numbers.rational(x)) return log_of_rational(*rational, numbers);
  if (numbers.is_algebraic(x))
    for (const int n : {2, 3, 4, 5, 6})
      if (const auto rational = numbers.rational(symbolic::power(x, n)))
        return Formula(Rational(1, n)) * log_of_rational(*rational, numbers);
  return numbers.elementary("log", x);
}

// The product of the factors whose logarithm is known, as its logarithm, and the rest.
struct Split {
  Scalar exponent;
  Formula rest = 1;
};
Split split(const Formula& product, Numbers& numbers) {
  Split result;
  const Factors all = symbolic::factors(product);
  std::vector<Formula> rest;
  for (const auto& [factor, n] : all.powers) {
    if (const auto operand = inside(factor, "exp", numbers))
      result.exponent = result.exponent + Scalar(n) * scalar_of(*operand, numbers);
    else
      rest.push_back(symbolic::power(factor, n));
  }
  if (all.constant > 0)
    result.exponent = result.exponent + Scalar(log_of_rational(all.constant, numbers));
  else
    rest.push_back(Formula(all.constant));
  result.rest = symbolic::product(std::move(rest));
  return result;
}

// The same for a sum of one term; of several, its greatest rational divisor.
Split split_sum(const Formula& sum, Numbers& numbers) {
  const std::vector<Monomial> all = symbolic::monomials(sum, numbers);
  if (all.size() == 1)
    return split(symbolic::product({Formula(all[0].coefficient), all[0].powers}), numbers);
  Rational content = 0;
  for (const Monomial& term : all)
    content = Rational(gcd(content.get_num(), term.coefficient.get_num()),
                       lcm(content.get_den(), term.coefficient.get_den()));
  if (content == 0) return {{}, 0};
  std::vector<Formula> parts;
  for (const auto& [coefficient, powers] : all)
    parts.push_back(symbolic::product({Formula(Rational(coefficient / content)), powers}));
  return {Scalar(log_of_rational(content, numbers)), symbolic::sum(std::move(parts))};
}

Scalar log_of_rest(const Formula& x, Numbers& numbers) {
  if (!symbolic::is_number(x)) return Scalar(Formula::applied("log", {x}));
  if (numbers.sign(x) != exact::Sign::positive)
    throw symbolic::NumberError("logarithm of a number that is not positive");
  return Scalar(log_of_number(x, numbers));
}

Scalar log(const Scalar& x, Numbers& numbers) {
  const Split above = split_sum(x.numerator, numbers);
  const Split below = split_sum(x.denominator, numbers);
  Scalar result = where_defined(above.exponent - below.exponent, x);
  if (symbolic::is_number(above.rest) && symbolic::is_number(below.rest)) {
    const bool is_negative = numbers.sign(above.rest) == exact::Sign::negative &&
                             numbers.sign(below.rest) == exact::Sign::negative;
    const Formula side(is_negative ? -1 : 1);
    return where_defined(result + log_of_rest(side * above.rest, numbers) -
                             log_of_rest(side * below.rest, numbers),
                         x);
  }
  const Formula quotient =
      below.rest.is(1) ? above.rest : above.rest * symbolic::inverse(below.rest);
  result = result + Scalar(Formula::applied("log", {quotient}));
  result.radicands.push_back(above.rest * below.rest);
  result.divisors.push_back(above.rest);
  return result;
}

}  // namespace

Scalar elementary(const std::string& function, const Scalar& x, Numbers& numbers) {
  if (function == "exp") return exp(x, numbers);
  if (function == "log") return log(x, numbers);
  const Turn both = turn(x, numbers);
  return where_defined(Scalar(function == "cos" ? both.cos : both.sin), x);
}

std::optional<Scalar> exponent(const Scalar& x, Numbers& numbers) {
  Scalar result;
  for (const bool above : {true, false}) {
    const auto terms = symbolic::monomials(above ? x.numerator : x.denominator, numbers);
    if (terms.size() != 1 || terms[0].coefficient <= 0) return std::nullopt;
    const Split parts = split(terms[0].powers, numbers);
    if (!parts.rest.is(1)) return std::nullopt;
    const Scalar log = parts.exponent + Scalar(log_of_rational(terms[0].coefficient, numbers));
    result = above ? log : result - log;
  }
  return where_defined(result, x);
}

bool is_exponential(const Formula& f) {
  return f.kind() == Formula::Kind::applied && f.name() == "exp";
}

}  // namespace seam::claims
