// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/square.h"

#include <flint/fmpq_mpoly_factor.h>

#include "exact/field.h"
#include "exact/polynomial_body.h"

// f is divided by one of its coefficients: if it is a number times a rational polynomial, that
// leaves a rational polynomial, which FLINT factors.

namespace seam::exact {

namespace {

bool is_rational(const Polynomial& f) {
  for (const auto& [exponents, number] : f.numerators().terms)
    for (std::size_t i = 1; i < number.size(); ++i)
      if (number[i] != 0) return false;
  return true;
}

}  // namespace

std::optional<SquareFactor> square_factor(const Polynomial& f) {
  if (f.is_number()) return std::nullopt;
  const Ring& ring = f.ring();
  const auto numerators = f.numerators();
  const Polynomial lead =
      ring.number(numerators.terms.rbegin()->second, numerators.denominator);
  const Polynomial monic = inverse(lead) * f;
  if (!is_rational(monic)) return std::nullopt;

  const auto* context = ring.body().context;
  fmpq_mpoly_factor_t factors;
  fmpq_mpoly_factor_init(factors, context);
  Polynomial root = ring.constant(1), cofactor = lead;
  if (fmpq_mpoly_factor_squarefree(factors, monic.body().it, context) != 0) {
    flint::Fmpq constant;
    fmpq_mpoly_factor_get_constant_fmpq(constant.it, factors, context);
    cofactor = flint::rational(constant.it) * cofactor;
    for (slong i = 0; i < fmpq_mpoly_factor_length(factors, context); ++i) {
      auto base = std::make_shared<Polynomial::Body>(monic.body().ring);
      fmpq_mpoly_factor_get_base(base->it, factors, i, context);
      const auto exponent = static_cast<int>(fmpq_mpoly_factor_get_exp_si(factors, i, context));
      const Polynomial factor(base);
      root = root * factor.pow(exponent / 2);
      if (exponent % 2 == 1) cofactor = cofactor * factor;
    }
  }
  fmpq_mpoly_factor_clear(factors, context);
  if (root.is_number()) return std::nullopt;
  return SquareFactor{root, cofactor};
}

}  // namespace seam::exact
