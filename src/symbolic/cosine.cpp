// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/forest.h"

// cos(p pi / q) for 0 < p/q < 1/2. With t = pi p/q, U(cos t) = sin(q t) / sin t = 0 for
// Chebyshev's polynomial U of degree q - 1, whose roots are the cos(k pi / q), 0 < k < q: all
// different, and at least 1 - cos(pi / q) > 4 / q^2 apart. So the interval, which Arb's ball
// around cos(p pi / q) lies in and which is not wider than 1/2000, holds this root alone for q
// <= 60. That it is one is a fact of the number, which the checker verifies.

namespace seam::symbolic {

using exact::Integer;
using exact::Rational;

namespace {

constexpr long largest = 60;
constexpr long grid = 1 << 14;

Formula chebyshev(long degree, const Formula& x) {
  Formula before = 0, now = 1;
  for (long k = 0; k < degree; ++k) {
    const Formula next = product({Formula(2), x, now}) - before;
    before = now;
    now = next;
  }
  return now;
}

exact::Enclosure about(const Rational& turn) {
  const auto ring = exact::Ring::make(nullptr, {"pi", "cos"});
  const std::vector<exact::Applied> values = {{"pi", ring->constant(0)},
                                              {"cos", turn * ring->variable(0)}};
  return *exact::enclosure(ring->variable(1), values, 64);
}

Integer floored(const Rational& x) {
  Integer result;
  mpz_fdiv_q(result.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
  return result;
}

}  // namespace

Formula Numbers::cosine_of_pi(const Rational& multiple) {
  Rational turn = abs(multiple);
  turn -= 2 * Rational(floored(turn / 2));
  if (turn > 1) turn = 2 - turn;
  if (turn > Rational(1, 2)) return -cosine_of_pi(1 - turn);
  if (turn == 0) return {1};
  if (turn == Rational(1, 2)) return {0};
  if (turn.get_den() > largest)
    throw NumberLimit("cosines of pi divided by more than 60 are not covered");
  const std::string key = turn.get_str();
  if (const auto known = forest_->cosines.find(key); known != forest_->cosines.end())
    return known->second;
  const auto [low, high] = about(turn);
  const Formula x = Formula::symbol("x");
  const Formula result =
      root(chebyshev(turn.get_den().get_si() - 1, x), "x",
           Rational(floored(low * grid) - 1, grid), Rational(floored(high * grid) + 2, grid));
  forest_->cosines.emplace(key, result);
  return result;
}

}  // namespace seam::symbolic
