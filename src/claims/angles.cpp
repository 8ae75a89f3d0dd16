// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/angles.h"

#include <algorithm>
#include <cstdlib>
#include <map>

#include "claims/evaluate.h"
#include "symbolic/denominator.h"

namespace seam::claims {

using exact::Integer;
using symbolic::Factors;

namespace {

bool holds_inverse(const Formula& f) {
  return f.kind() == Formula::Kind::inverse || std::ranges::any_of(f.operands(), holds_inverse);
}

}  // namespace

Turn together(const Turn& a, const Turn& b) {
  return {a.cos * b.cos - a.sin * b.sin, a.sin * b.cos + a.cos * b.sin};
}

// By powers of cos + i sin.
Turn multiple(const Turn& unit, long n) {
  Turn result{1, 0}, square = unit;
  for (long rest = std::labs(n); rest > 0; rest /= 2) {
    if (rest % 2 == 1) result = together(result, square);
    if (rest > 1) square = together(square, square);
  }
  return {result.cos, n < 0 ? -result.sin : result.sin};
}

Formula divided(const Formula& monomial, const Integer& divisor) {
  const Factors all = symbolic::factors(monomial);
  return symbolic::product(Factors{all.constant / exact::Rational(divisor), all.powers});
}

Angles::Angle Angles::angle(const Formula& applied) {
  const Formula& operand = applied.operands()[0];
  const bool is_exp = applied.name() == "exp";
  const Factors all = symbolic::factors(operand);
  if (all.constant.get_num() != 1) return {is_exp, operand, 1};
  return {is_exp, symbolic::product(Factors{1, all.powers}), all.constant.get_den()};
}

void Angles::add(const Formula& f) {
  if (f.kind() != Formula::Kind::applied || !symbolic::is_elementary(f.name())) return;
  const Angle own = angle(f);
  for (Angle& known : angles_)
    if (known.is_exp == own.is_exp && known.monomial.same(own.monomial)) {
      known.divisor = lcm(known.divisor, own.divisor);
      return;
    }
  angles_.push_back(own);
}

Formula Angles::in_finest(const Formula& f) const {
  if (!symbolic::is_elementary(f.name())) throw Unsupported("the function '" + f.name() + "'");
  if (holds_inverse(f.operands()[0])) throw Unsupported("a function of a quotient");
  if (f.name() == "log") return f;
  const Angle own = angle(f);
  const auto known = std::ranges::find_if(angles_, [&](const Angle& other) {
    return other.is_exp == own.is_exp && other.monomial.same(own.monomial);
  });
  if (known == angles_.end() || known->divisor == own.divisor) return f;
  const Integer times = known->divisor / own.divisor;
  if (times > 1000) throw Unsupported("multiples over 1000 in a function");
  const Formula operand = divided(own.monomial, known->divisor);
  const int n = static_cast<int>(times.get_si());
  if (own.is_exp) return symbolic::power(Formula::applied("exp", {operand}), n);
  const Turn all =
      multiple({Formula::applied("cos", {operand}), Formula::applied("sin", {operand})}, n);
  return f.name() == "cos" ? all.cos : all.sin;
}

certificate::Elementary kind_of(const std::string& function) {
  using certificate::Elementary;
  static const std::map<std::string, Elementary> kinds = {{"exp", Elementary::exp},
                                                          {"log", Elementary::log},
                                                          {"sin", Elementary::sin},
                                                          {"cos", Elementary::cos},
                                                          {"pi", Elementary::pi}};
  const auto found = kinds.find(function);
  return found == kinds.end() ? Elementary::none : found->second;
}

}  // namespace seam::claims
