// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/recognise.h"

#include <flint/fmpz_lll.h>

#include "exact/contract.h"
#include "exact/enclosures.h"

// A relation r0 value + sum r_i basis_i = 0 with small integers is a short vector of the
// lattice of the rows (unit vector, 2^bits * number). By chance a relation has entries of about
// bits / (dimension + 1) bits; one with much smaller entries is believed.

namespace seam::exact {

namespace {

Integer rounded(const Rational& x) {
  const Rational shifted = x + Rational(1, 2);
  Integer result;
  mpz_fdiv_q(result.get_mpz_t(), shifted.get_num_mpz_t(), shifted.get_den_mpz_t());
  return result;
}

Rational scaled(Rational x, long bits) {
  mpq_mul_2exp(x.get_mpq_t(), x.get_mpq_t(), bits);
  return x;
}

}  // namespace

std::optional<Polynomial> recognise(const RingPtr& numbers, const Rational& value, long bits) {
  const int size = dimension(numbers->tower());
  fmpz_mat_t lattice;
  fmpz_mat_init(lattice, size + 1, size + 2);
  for (int i = 0; i <= size; ++i) {
    fmpz_one(fmpz_mat_entry(lattice, i, i));
    Rational number = value;
    if (i > 0) {
      Coordinates unit(size);
      unit[i - 1] = 1;
      number = enclosure(numbers->tower(), unit, bits + 16).low;
    }
    const Integer entry = rounded(scaled(number, bits));
    fmpz_set_mpz(fmpz_mat_entry(lattice, i, size + 1), entry.get_mpz_t());
  }
  fmpz_lll_t context;
  fmpz_lll_context_init_default(context);
  fmpz_lll(lattice, nullptr, context);
  Integer lead = flint::integer(fmpz_mat_entry(lattice, 0, 0));
  Coordinates relation(size);
  std::size_t largest = mpz_sizeinbase(lead.get_mpz_t(), 2);
  for (int i = 0; i < size; ++i) {
    relation[i] = -flint::integer(fmpz_mat_entry(lattice, 0, i + 1));
    largest = std::max(largest, mpz_sizeinbase(relation[i].get_mpz_t(), 2));
  }
  fmpz_mat_clear(lattice);
  if (lead == 0 || static_cast<long>(largest) * (size + 1) * 3 / 2 > bits) return std::nullopt;
  if (lead < 0) {
    lead = -lead;
    for (Integer& c : relation) c = -c;
  }
  return numbers->number(relation, lead);
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
