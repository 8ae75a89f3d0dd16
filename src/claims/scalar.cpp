// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/scalar.h"

#include <algorithm>
#include <cstdlib>
#include <unordered_map>

#include "claims/elementary.h"
#include "symbolic/denominator.h"

// Divisors and radicands only ever accumulate: an operation has those of its operands, and
// a quotient or a root also what it divides by or is the root of. So a value that the
// text leaves undefined somewhere can never look defined there after cancellation.

namespace seam::claims {
namespace {

using symbolic::common_denominator;
using symbolic::Fact;
using symbolic::factors;
using symbolic::Factors;
using symbolic::merged_product;
using symbolic::product;

void add(std::vector<Formula>& all, const Formula& formula) {
  const bool known =
      std::ranges::any_of(all, [&](const Formula& f) { return f.same(formula); });
  if (!known) all.push_back(formula);
}

// `result` with what a and b rest on.
Scalar resting(Scalar result, const Scalar& a, const Scalar& b) {
  for (const Scalar* operand : {&a, &b}) {
    for (const Formula& divisor : operand->divisors) add(result.divisors, divisor);
    for (const Formula& radicand : operand->radicands) add(result.radicands, radicand);
  }
  return result;
}

Scalar over(Formula numerator, Formula denominator) {
  Scalar result(std::move(numerator));
  result.denominator = std::move(denominator);
  return result;
}

bool has_variables(const Scalar& s) {
  return !symbolic::is_number(s.numerator) || !symbolic::is_number(s.denominator);
}

}  // namespace

bool Scalar::is_polynomial() const {
  return denominator.is(1) && divisors.empty() && radicands.empty() &&
         numerator.is_polynomial();
}

Scalar operator+(const Scalar& a, const Scalar& b) {
  const symbolic::Common c = common_denominator(a.denominator, b.denominator);
  return resting(over(a.numerator * c.beside_a + b.numerator * c.beside_b, c.common), a, b);
}

Scalar operator-(const Scalar& a) {
  return resting(over(-a.numerator, a.denominator), a, a);
}
Scalar operator-(const Scalar& a, const Scalar& b) {
  if (a.denominator.is(1) && b.denominator.is(1))
    return resting(over(a.numerator - b.numerator, 1), a, b);
  return a + -b;
}

Scalar operator*(const Scalar& a, const Scalar& b) {
  return resting(over(a.numerator * b.numerator, merged_product(a.denominator, b.denominator)),
                 a, b);
}

Scalar divide(const Scalar& a, const Scalar& b, Numbers& numbers) {
  const Formula& divisor = b.numerator;
  if (symbolic::is_number(divisor)) {
    if (divisor.is_constant() && divisor.value() == 0) throw DivisionByZero();
    if (!divisor.is_constant() && numbers.sign(divisor) == exact::Sign::zero)
      throw DivisionByZero();
    if (!numbers.is_algebraic(divisor)) {
      Scalar result = resting(
          over(a.numerator * b.denominator, merged_product(a.denominator, divisor)), a, b);
      add(result.divisors, divisor);
      return result;
    }
    const Formula inverse =
        divisor.is_constant() ? symbolic::inverse(divisor) : numbers.inverse(divisor);
    return resting(over(a.numerator * b.denominator * inverse, a.denominator), a, b);
  }
  const Factors all = factors(divisor);
  Formula number = symbolic::inverse(Formula(all.constant));
  Factors below;
  std::vector<Formula> divisors;
  for (const auto& [factor, exponent] : all.powers) {
    if (symbolic::is_number(factor)) {
      number = number * symbolic::power(numbers.inverse(factor), exponent);
    } else {
      below.powers.emplace_back(factor, exponent);
      if (!is_exponential(factor)) divisors.push_back(factor);
    }
  }
  Scalar result = resting(
      over(a.numerator * b.denominator * number, merged_product(a.denominator, product(below))),
      a, b);
  for (const Formula& factor : divisors) add(result.divisors, factor);
  return result;
}

Scalar power(const Scalar& base, long exponent, Numbers& numbers) {
  if (std::labs(exponent) > 1000)
    throw symbolic::NumberError("an exponent of more than 1000 is too large");
  if (exponent < 0) return divide(Scalar(1), power(base, -exponent, numbers), numbers);
  const int n = static_cast<int>(exponent);
  return resting(over(symbolic::power(base.numerator, n), symbolic::power(base.denominator, n)),
                 base, base);
}

namespace {

// Certainly not negative, as it is written.
bool is_size(const Formula& f) {
  const Factors all = factors(f);
  return all.constant >= 0 && std::ranges::all_of(all.powers, [](const auto& p) {
           return p.second % 2 == 0 || p.first.kind() == Formula::Kind::root ||
                  is_exponential(p.first);
         });
}

}  // namespace

Scalar absolute(const Scalar& x, Numbers& numbers) {
  const auto size = [&](const Formula& f) {
    if (is_size(f)) return f;
    if (symbolic::is_number(f)) return numbers.sign(f) == exact::Sign::negative ? -f : f;
    return symbolic::root(symbolic::power(f, 2), 2);
  };
  return resting(over(size(x.numerator), size(x.denominator)), x, x);
}

std::optional<Scalar> inside_absolute(const Scalar& x) {
  const Formula& root = x.numerator;
  if (root.kind() != Formula::Kind::root || root.exponent() != 2 || !is_size(x.denominator))
    return std::nullopt;
  const Formula& square = root.operands()[0];
  if (square.kind() != Formula::Kind::power || square.exponent() != 2) return std::nullopt;
  return resting(over(square.operands()[0], x.denominator), x, x);
}

// The root of n/d is that of n * rest, over |d * rest| taken once, where d * rest is an
// n-th power.
Scalar nth_root(const Scalar& x, int n, Numbers& numbers) {
  if (!has_variables(x)) {
    const Formula below = x.denominator.is(1) ? Formula(1) : numbers.inverse(x.denominator);
    return resting(numbers.nth_root(x.numerator * below, n), x, x);
  }
  if (n % 2 == 1) throw symbolic::NumberLimit("an odd root of a function is not covered");
  Factors rest, below;
  for (const auto& [factor, exponent] : factors(x.denominator).powers) {
    const int up = (exponent + n - 1) / n;
    below.powers.emplace_back(factor, up);
    if (const int more = n * up - exponent; more > 0) rest.powers.emplace_back(factor, more);
  }
  const Formula radicand = x.numerator * product(rest);
  const Formula root = symbolic::is_number(radicand) ? numbers.nth_root(radicand, n)
                                                     : symbolic::root(radicand, n);
  Scalar result = resting(over(root, absolute(product(below), numbers).numerator), x, x);
  if (!symbolic::is_number(radicand)) add(result.radicands, radicand);
  return result;
}

namespace {

using Memo = std::unordered_map<const void*, Scalar>;

// A formula with its inverses and roots worked out as quotients and, of numbers, as numbers.
class Walk {
 public:
  Walk(const std::map<std::string, Scalar>& map, Numbers& numbers)
      : map_(map), numbers_(numbers) {}

  Scalar operator()(const Formula& f) {
    if (f.is_constant() || (f.kind() == Formula::Kind::known && f.is_polynomial())) return {f};
    if (f.kind() == Formula::Kind::symbol) {
      const auto found = map_.find(f.name());
      return found == map_.end() ? Scalar(f) : found->second;
    }
    if (map_.empty() && f.is_polynomial()) return {f};
    if (const auto found = memo_.find(f.identity()); found != memo_.end()) return found->second;
    Scalar result = compute(f);
    memo_.emplace(f.identity(), result);
    return result;
  }

  // What a value rested on before it still rests on, in the new symbols.
  void rest_on(Scalar& result, const std::vector<Formula>& divisors,
               const std::vector<Formula>& radicands) {
    for (const Formula& divisor : divisors)
      result = resting(result, divide(Scalar(1), (*this)(divisor), numbers_), {});
    for (const Formula& radicand : radicands)
      result = resting(result, nth_root((*this)(radicand), 2, numbers_), {});
  }

 private:
  Scalar compute(const Formula& f) {
    const auto inner = [&] { return (*this)(f.operands()[0]); };
    switch (f.kind()) {
      case Formula::Kind::sum:
      case Formula::Kind::product: {
        const bool is_sum = f.kind() == Formula::Kind::sum;
        Scalar result(is_sum ? 0 : 1);
        for (const Formula& operand : f.operands()) {
          const Scalar next = (*this)(operand);
          result = is_sum ? result + next : result * next;
        }
        return result;
      }
      case Formula::Kind::power:
        return power(inner(), f.exponent(), numbers_);
      case Formula::Kind::inverse:
        return divide(Scalar(1), inner(), numbers_);
      case Formula::Kind::root:
        return nth_root(inner(), f.exponent(), numbers_);
      case Formula::Kind::applied: {
        if (symbolic::is_elementary(f.name()) && !map_.empty())
          return elementary(f.name(), inner(), numbers_);
        std::vector<Formula> operands;
        Scalar rest(0);
        for (const Formula& operand : f.operands()) {
          const Scalar value = (*this)(operand);
          operands.push_back(value.denominator.is(1)
                                 ? value.numerator
                                 : value.numerator * symbolic::inverse(value.denominator));
          rest = rest + value;
        }
        const Scalar result(Formula::applied(f.name(), std::move(operands), f.orders()));
        return resting(result, rest, rest);
      }
      default: {
        Scalar result = inner();
        for (const Fact& fact : f.facts()) {
          if (fact.relation == Fact::Relation::nonzero)
            rest_on(result, {fact.formula}, {});
          else
            rest_on(result, {}, {fact.formula});
        }
        return result;
      }
    }
  }

  const std::map<std::string, Scalar>& map_;
  Numbers& numbers_;
  Memo memo_;
};

}  // namespace

Scalar substitute(const Scalar& value, const std::map<std::string, Scalar>& map,
                  Numbers& numbers) {
  const bool polynomial =
      value.is_polynomial() &&
      std::ranges::all_of(map, [](const auto& entry) { return entry.second.is_polynomial(); });
  if (polynomial) {
    std::map<std::string, Formula> formulas;
    for (const auto& [name, scalar] : map) formulas.emplace(name, scalar.numerator);
    return {symbolic::subst(value.numerator, formulas)};
  }
  Walk walk(map, numbers);
  Scalar result = divide(walk(value.numerator), walk(value.denominator), numbers);
  walk.rest_on(result, value.divisors, value.radicands);
  return result;
}

Scalar scalar_of(const Formula& f, Numbers& numbers) {
  if (f.is_polynomial()) return {f};
  return Walk({}, numbers)(f);
}

Formula formula_of(const Scalar& s) {
  if (s.is_polynomial()) return s.numerator;
  std::vector<Fact> facts;
  for (const Formula& divisor : s.divisors) facts.push_back({divisor, Fact::Relation::nonzero});
  for (const Formula& radicand : s.radicands)
    facts.push_back({radicand, Fact::Relation::nonnegative});
  return Formula::known(s.numerator * symbolic::inverse(s.denominator), std::move(facts));
}

bool is_number(const Scalar& value) {
  return value.is_polynomial() && symbolic::is_number(value.numerator);
}

}  // namespace seam::claims
