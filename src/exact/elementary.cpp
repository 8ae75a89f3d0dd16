// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/elementary.h"

#include "exact/contract.h"
#include "exact/enclosures.h"
#include "exact/flint.h"

// Arb's balls hold the values of its functions on balls. Exponents of balls are integers of any
// size; bounds are fractions, so those of a number that is too large or too small to be written
// as one are not given.

namespace seam::exact {

using flint::Arb;
using flint::Fmpz;

namespace {

Arb value(const Polynomial& f, const std::vector<Arb>& values, long precision) {
  const auto [terms, denominator] = f.numerators();
  Arb sum;
  for (const auto& [exponents, coordinates] : terms) {
    Arb term = evaluate(f.ring().tower(), coordinates, precision);
    for (std::size_t i = 0; i < exponents.size(); ++i) {
      if (exponents[i] == 0) continue;
      require(i < values.size(), "enclosure: a variable without a value");
      Arb power;
      arb_pow_ui(power.it, values[i].it, exponents[i], precision);
      arb_mul(term.it, term.it, power.it, precision);
    }
    arb_add(sum.it, sum.it, term.it, precision);
  }
  arb_div_fmpz(sum.it, sum.it, Fmpz(denominator).it, precision);
  return sum;
}

Arb applied(const std::string& function, const Arb& x, long precision) {
  Arb result;
  if (function == "exp") {
    arb_exp(result.it, x.it, precision);
  } else if (function == "log") {
    arb_log(result.it, x.it, precision);
  } else if (function == "sin") {
    arb_sin(result.it, x.it, precision);
  } else if (function == "cos") {
    arb_cos(result.it, x.it, precision);
  } else if (function == "inverse") {
    arb_inv(result.it, x.it, precision);
  } else {
    require(function == "pi", "enclosure: an unknown function");
    arb_const_pi(result.it, precision);
  }
  return result;
}

constexpr long most_bits = 1L << 22;  // of a fraction

bool is_short(const Arb& ball) {
  const auto has_small = [](const fmpz* exponent) {
    return fmpz_cmp_si(exponent, most_bits) <= 0 && fmpz_cmp_si(exponent, -most_bits) >= 0;
  };
  return arb_is_finite(ball.it) != 0 && has_small(ARF_EXPREF(arb_midref(ball.it))) &&
         has_small(MAG_EXPREF(arb_radref(ball.it)));
}

}  // namespace

std::optional<Enclosure> enclosure(const Polynomial& number, const std::vector<Applied>& values,
                                   long precision) {
  std::vector<Arb> balls;
  for (const auto& [function, argument] : values)
    balls.push_back(applied(function, value(argument, balls, precision), precision));
  const Arb ball = value(number, balls, precision);
  if (!is_short(ball)) return std::nullopt;
  return bounds(ball);
}

}  // namespace seam::exact
