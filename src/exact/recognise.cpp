// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/recognise.h"

#include <flint/fmpz_lll.h>

#include "exact/contract.h"
#include "exact/enclosures.h"

// A relation sum r_i x_i = 0 with small integers is a short vector of the lattice of the rows
// (unit vector, 2^bits * x_i). By chance a relation of n numbers has entries of about bits / n
// bits; one with much smaller entries is believed.

namespace seam::exact {

namespace {

Integer rounded(const Rational& x) {
  const Rational shifted = x + Rational(1, 2);
  Integer result;
  mpz_fdiv_q(result.get_mpz_t(), shifted.get_num_mpz_t(), shifted.get_den_mpz_t());
  return result;
}

// Small integers, not all 0, with sum r_i numbers_i about 0; none if there seem to be none.
Coordinates relation(const std::vector<Rational>& numbers, long bits) {
  const int size = static_cast<int>(numbers.size());
  fmpz_mat_t lattice;
  fmpz_mat_init(lattice, size, size + 1);
  for (int i = 0; i < size; ++i) {
    fmpz_one(fmpz_mat_entry(lattice, i, i));
    const Integer entry = rounded(scaled(numbers[i], bits));
    fmpz_set_mpz(fmpz_mat_entry(lattice, i, size), entry.get_mpz_t());
  }
  fmpz_lll_t context;
  fmpz_lll_context_init_default(context);
  fmpz_lll(lattice, nullptr, context);
  Coordinates result(size);
  std::size_t largest = 0;
  for (int i = 0; i < size; ++i) {
    result[i] = flint::integer(fmpz_mat_entry(lattice, 0, i));
    largest = std::max(largest, mpz_sizeinbase(result[i].get_mpz_t(), 2));
  }
  fmpz_mat_clear(lattice);
  if (static_cast<long>(largest) * size * 3 / 2 > bits) return {};
  return result;
}

}  // namespace

Rational scaled(Rational x, long bits) {
  if (bits >= 0)
    mpq_mul_2exp(x.get_mpq_t(), x.get_mpq_t(), bits);
  else
    mpq_div_2exp(x.get_mpq_t(), x.get_mpq_t(), -bits);
  return x;
}

Rational truncated(const Rational& x, long bits) {
  const Rational shifted = scaled(x, bits);
  Integer whole;
  mpz_fdiv_q(whole.get_mpz_t(), shifted.get_num_mpz_t(), shifted.get_den_mpz_t());
  return scaled(Rational(whole), -bits);
}

std::optional<Polynomial> recognise(const RingPtr& numbers, const Rational& value, long bits) {
  const int size = dimension(numbers->tower());
  std::vector<Rational> all = {value};
  for (int i = 0; i < size; ++i) {
    Coordinates unit(size);
    unit[i] = 1;
    all.push_back(enclosure(numbers->tower(), unit, bits + 16).low);
  }
  Coordinates found = relation(all, bits);
  if (found.empty() || found[0] == 0) return std::nullopt;
  Integer lead = found[0];
  found.erase(found.begin());
  for (Integer& c : found) c = -c;
  if (lead < 0) {
    lead = -lead;
    for (Integer& c : found) c = -c;
  }
  return numbers->number(found, lead);
}

std::optional<Univariate> annihilator(const RingPtr& numbers, const Rational& value, int most,
                                      long bits) {
  std::vector<Rational> powers = {1};
  for (int degree = 1; degree <= most; ++degree) {
    powers.push_back(truncated(powers.back() * value, bits + 16));
    const Coordinates found = relation(powers, bits);
    if (found.empty() || found.back() == 0) continue;
    Univariate result;
    for (const Integer& c : found) result.push_back(numbers->constant(Rational(c)));
    return result;
  }
  return std::nullopt;
}

Rational simplest(const Rational& value, const Rational& tolerance) {
  require(tolerance > 0, "simplest: no tolerance");
  const Rational low = value - tolerance, high = value + tolerance;
  Integer whole;
  mpz_cdiv_q(whole.get_mpz_t(), low.get_num_mpz_t(), low.get_den_mpz_t());
  if (whole <= high) return whole;
  // Both ends lie strictly between whole - 1 and whole.
  const Integer below = whole - 1;
  const Rational a = low - below, b = high - below;
  const Rational centre = (1 / a + 1 / b) / 2, reach = (1 / a - 1 / b) / 2;
  return below + 1 / simplest(centre, reach);
}

}  // namespace seam::exact
