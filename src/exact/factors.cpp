// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/factors.h"

#include <flint/fmpq_mpoly_factor.h>

#include "exact/contract.h"
#include "exact/field.h"
#include "exact/polynomial_body.h"

// The normal form of f is a rational polynomial in variables and generators. What FLINT finds
// are factors of that, hence of f; each is in normal form, for its degree in a generator is not
// above that of f. A number in front is taken out first, so that it hides no factor.

namespace seam::exact {

Factors factors(const Polynomial& f) {
  require(!f.is_zero(), "factors: of 0");
  const Ring& ring = f.ring();
  const auto numerators = f.numerators();
  Factors result{ring.number(numerators.terms.rbegin()->second, numerators.denominator), {}};
  const Polynomial monic = inverse(result.number) * f;

  const auto* context = ring.body().context;
  fmpq_mpoly_factor_t found;
  fmpq_mpoly_factor_init(found, context);
  if (fmpq_mpoly_factor(found, monic.body().it, context) == 0) {
    result.factors.emplace_back(monic, 1);
  } else {
    flint::Fmpq constant;
    fmpq_mpoly_factor_get_constant_fmpq(constant.it, found, context);
    result.number = flint::rational(constant.it) * result.number;
    for (slong i = 0; i < fmpq_mpoly_factor_length(found, context); ++i) {
      auto base = std::make_shared<Polynomial::Body>(monic.body().ring);
      fmpq_mpoly_factor_get_base(base->it, found, i, context);
      const auto exponent = static_cast<int>(fmpq_mpoly_factor_get_exp_si(found, i, context));
      const Polynomial factor(base);
      if (factor.is_number())
        result.number = result.number * factor.pow(exponent);
      else
        result.factors.emplace_back(factor, exponent);
    }
  }
  fmpq_mpoly_factor_clear(found, context);
  return result;
}

}  // namespace seam::exact
