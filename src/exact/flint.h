// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <flint/fmpq_mpoly.h>
#include <flint/fmpz_mat.h>
#include <flint/fmpz_mpoly.h>
#include <flint/fmpz_poly.h>
#include <flint/fmpz_poly_factor.h>
//
#include <arb.h>

#include "exact/rational.h"

// Owners for the types of FLINT and Arb. Only the sources of src/exact include this.
namespace seam::exact::flint {

struct Fmpz {
  fmpz_t it;
  Fmpz() { fmpz_init(it); }
  explicit Fmpz(const Integer& value) : Fmpz() { fmpz_set_mpz(it, value.get_mpz_t()); }
  ~Fmpz() { fmpz_clear(it); }
  Fmpz(const Fmpz& other) : Fmpz() { fmpz_set(it, other.it); }
  Fmpz& operator=(const Fmpz& other) {
    fmpz_set(it, other.it);
    return *this;
  }
};

inline Integer integer(const fmpz_t value) {
  Integer result;
  fmpz_get_mpz(result.get_mpz_t(), value);
  return result;
}

struct Fmpq {
  fmpq_t it;
  Fmpq() { fmpq_init(it); }
  explicit Fmpq(const Rational& value) : Fmpq() { fmpq_set_mpq(it, value.get_mpq_t()); }
  ~Fmpq() { fmpq_clear(it); }
  Fmpq(const Fmpq&) = delete;
  Fmpq& operator=(const Fmpq&) = delete;
};

inline Rational rational(const fmpq_t value) {
  Rational result;
  fmpq_get_mpq(result.get_mpq_t(), value);
  return result;
}

struct Arb {
  arb_t it;
  Arb() { arb_init(it); }
  Arb(const Rational& value, long precision) : Arb() {
    const Fmpq q(value);
    arb_set_fmpq(it, q.it, precision);
  }
  ~Arb() { arb_clear(it); }
  Arb(const Arb& other) : Arb() { arb_set(it, other.it); }
  Arb& operator=(const Arb& other) {
    arb_set(it, other.it);
    return *this;
  }
};

/// A polynomial with integer coefficients in the symbols of one context.
struct Mpoly {
  fmpz_mpoly_t it;
  const fmpz_mpoly_ctx_struct* context;
  explicit Mpoly(const fmpz_mpoly_ctx_struct* ctx) : context(ctx) { fmpz_mpoly_init(it, ctx); }
  ~Mpoly() { fmpz_mpoly_clear(it, context); }
  Mpoly(const Mpoly& other) : Mpoly(other.context) { fmpz_mpoly_set(it, other.it, context); }
  Mpoly(Mpoly&& other) noexcept : Mpoly(other.context) {
    fmpz_mpoly_swap(it, other.it, context);
  }
  Mpoly& operator=(const Mpoly& other) {
    fmpz_mpoly_set(it, other.it, context);
    return *this;
  }
  Mpoly& operator=(Mpoly&& other) noexcept {
    fmpz_mpoly_swap(it, other.it, context);
    return *this;
  }
};

}  // namespace seam::exact::flint
