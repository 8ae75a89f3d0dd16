// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/tower.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "exact/contract.h"
#include "exact/enclosures.h"

// Why `sign` ends.
//
//   The basis is one over the rationals (each defining polynomial is irreducible over the field
//   below), so a number with a nonzero coordinate is not 0, and some precision separates it
//   from 0.
//
// Why an enclosure of a root is narrowed to any precision.
//
//   The bracket holds one root, and the signs at its ends differ. Halving keeps that. A
//   midpoint is rational, hence no root of an irreducible polynomial of degree >= 2. Once the
//   derivative has no zero in the bracket (the root is simple) Newton's interval step m -
//   p(m)/p'(X) doubles the digits.

namespace seam::exact {

using flint::Arb;
using flint::Fmpz;

Tower::Tower(TowerPtr below, std::string symbol, Integer scale, std::vector<Coordinates> tail,
             Rational low, Rational high)
    : below_(std::move(below)),
      symbol_(std::move(symbol)),
      scale_(std::move(scale)),
      tail_(std::move(tail)),
      low_(low * scale_),
      high_(high * scale_) {
  require(tail_.size() >= 2, "Tower: a root of degree 1 is no generator");
  require(scale_ > 0 && low_ < high_, "Tower: no interval");
}

Tower::~Tower() = default;

int dimension(const TowerPtr& tower) {
  return tower ? tower->degree() * dimension(tower->below()) : 1;
}

int height(const TowerPtr& tower) {
  return tower ? 1 + height(tower->below()) : 0;
}

std::vector<const Tower*> steps(const TowerPtr& tower) {
  std::vector<const Tower*> result;
  for (const Tower* step = tower.get(); step; step = step->below().get())
    result.push_back(step);
  std::ranges::reverse(result);
  return result;
}

namespace {

constexpr long hopeless = 1L << 22;  // bits; reached only if a promise was broken

// p = h^d - sum tail[j] h^j at x, or its derivative.
Arb defining(const std::vector<Arb>& tail, const Arb& x, bool derivative, long precision) {
  const int degree = static_cast<int>(tail.size());
  Arb result;
  arb_set_si(result.it, derivative ? degree : 1);
  for (int j = degree - 1; j >= (derivative ? 1 : 0); --j) {
    arb_mul(result.it, result.it, x.it, precision);
    if (derivative) {
      Arb term(tail[j]);
      arb_mul_si(term.it, term.it, j, precision);
      arb_sub(result.it, result.it, term.it, precision);
    } else {
      arb_sub(result.it, result.it, tail[j].it, precision);
    }
  }
  return result;
}

std::vector<Arb> evaluate_all(const TowerPtr& tower, const std::vector<Coordinates>& numbers,
                              long precision) {
  std::vector<Arb> result;
  for (const Coordinates& number : numbers)
    result.push_back(evaluate(tower, number, precision));
  return result;
}

int sign_at(const Tower& tower, const Rational& x) {
  for (long precision = 64; precision < hopeless; precision *= 2) {
    const auto tail = evaluate_all(tower.below(), tower.tail(), precision);
    const Arb value = defining(tail, Arb(x, precision), false, precision);
    if (!arb_contains_zero(value.it)) return arb_is_positive(value.it) ? 1 : -1;
  }
  throw ContractError("Tower: the defining polynomial is reducible");
}

Arb bracket(const Rational& low, const Rational& high, long precision) {
  const Arb a(low, precision), b(high, precision);
  Arb result;
  arb_union(result.it, a.it, b.it, precision);
  return result;
}

// Narrows `e.root` by Newton's interval step until it no longer helps; false if the derivative
// may vanish.
bool newton(Tower::Enclosures& e, const std::vector<Arb>& tail, long precision) {
  for (;;) {
    const Arb slope = defining(tail, e.root, true, precision);
    if (arb_contains_zero(slope.it)) return false;
    Arb middle;
    arb_get_mid_arb(middle.it, e.root.it);
    Arb step = defining(tail, middle, false, precision);
    arb_div(step.it, step.it, slope.it, precision);
    arb_sub(step.it, middle.it, step.it, precision);
    Arb better;
    if (!arb_intersection(better.it, step.it, e.root.it, precision))
      throw ContractError("Tower: no root in its interval");
    mag_t half;
    mag_init(half);
    mag_mul_2exp_si(half, arb_radref(e.root.it), -1);
    const bool helped = mag_cmp(arb_radref(better.it), half) < 0;
    mag_clear(half);
    e.root = better;
    if (!helped) return true;
  }
}

void refine(const Tower& tower, Tower::Enclosures& e, long precision) {
  const int sign_low = sign_at(tower, e.low);
  if (e.precision == 0) {
    require(sign_low * sign_at(tower, e.high) < 0, "Tower: no change of sign");
  }
  for (long working = precision + 32; working < hopeless; working *= 2) {
    const auto tail = evaluate_all(tower.below(), tower.tail(), working);
    e.root = bracket(e.low, e.high, working);
    bool narrow = newton(e, tail, working);
    for (long halving = 0; !narrow && halving < working; ++halving) {
      const Rational middle = (e.low + e.high) / 2;
      (sign_at(tower, middle) == sign_low ? e.low : e.high) = middle;
      e.root = bracket(e.low, e.high, working);
      narrow = newton(e, tail, working);
    }
    if (arb_rel_accuracy_bits(e.root.it) >= precision) return;
  }
  throw ContractError("Tower: the root cannot be enclosed");
}

}  // namespace

const Tower::Enclosures& enclosures(const TowerPtr& tower, long precision) {
  auto& cached = tower->enclosures_;
  if (cached && cached->precision >= precision) return *cached;
  if (!cached) {
    cached = std::make_unique<Tower::Enclosures>();
    cached->low = tower->low_;
    cached->high = tower->high_;
  }
  auto& e = *cached;
  refine(*tower, e, precision);
  e.precision = precision;
  e.basis.clear();
  Arb power;
  arb_one(power.it);
  for (int exponent = 0; exponent < tower->degree(); ++exponent) {
    if (!tower->below()) {
      e.basis.push_back(power);
    } else {
      for (const Arb& b : enclosures(tower->below(), precision).basis) {
        e.basis.emplace_back();
        arb_mul(e.basis.back().it, b.it, power.it, precision + 32);
      }
    }
    arb_mul(power.it, power.it, e.root.it, precision + 32);
  }
  return e;
}

Arb evaluate(const TowerPtr& tower, const Coordinates& number, long precision) {
  require(std::ssize(number) == dimension(tower), "evaluate: wrong number of coordinates");
  Arb result;
  if (!tower) {
    arb_set_round_fmpz(result.it, Fmpz(number[0]).it, precision);
    return result;
  }
  const auto& basis = enclosures(tower, precision).basis;
  for (std::size_t i = 0; i < number.size(); ++i)
    if (number[i] != 0) arb_addmul_fmpz(result.it, basis[i].it, Fmpz(number[i]).it, precision);
  return result;
}

Sign sign(const TowerPtr& tower, const Coordinates& number) {
  if (std::ranges::all_of(number, [](const Integer& c) { return c == 0; })) return Sign::zero;
  if (!tower) return number[0] > 0 ? Sign::positive : Sign::negative;
  for (long precision = 64; precision < hopeless; precision *= 2) {
    const Arb value = evaluate(tower, number, precision);
    if (!arb_contains_zero(value.it))
      return arb_is_positive(value.it) ? Sign::positive : Sign::negative;
  }
  throw ContractError("sign: the tower is not a field");
}

Enclosure bounds(const Arb& ball) {
  Fmpz low, high, exponent;
  arb_get_interval_fmpz_2exp(low.it, high.it, exponent.it, ball.it);
  const auto scaled = [&](const Fmpz& x) {
    Rational result = flint::integer(x.it);
    const long shift = fmpz_get_si(exponent.it);
    if (shift >= 0)
      mpq_mul_2exp(result.get_mpq_t(), result.get_mpq_t(), shift);
    else
      mpq_div_2exp(result.get_mpq_t(), result.get_mpq_t(), -shift);
    return result;
  };
  return {scaled(low), scaled(high)};
}

Enclosure enclosure(const TowerPtr& tower, const Coordinates& number, long bits) {
  if (!tower) return {number[0], number[0]};
  for (long precision = bits + 32;; precision *= 2) {
    Enclosure result = bounds(evaluate(tower, number, precision));
    Rational allowed = std::max<Rational>(1, abs(result.low));
    mpq_div_2exp(allowed.get_mpq_t(), allowed.get_mpq_t(), bits);
    if (result.high - result.low <= allowed) return result;
  }
}

Ball ball(const TowerPtr& tower, const Coordinates& number) {
  const Arb value = evaluate(tower, number, 96);
  const double middle = arf_get_d(arb_midref(value.it), ARF_RND_NEAR);
  const double radius = mag_get_d(arb_radref(value.it));
  return {middle, radius * (1 + 1e-10) + std::abs(middle) * 0x1p-52 + 0x1p-1000};
}

}  // namespace seam::exact
