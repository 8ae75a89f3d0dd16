// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "claims/scalar.h"

namespace seam::claims {

/// The value of `exp`, `log`, `sin` or `cos` of a number or function, as a polynomial (for exp:
/// a quotient) in values of these at monomials, divided by integers. So what follows from
/// exp(a + b) = exp(a) exp(b) and the theorems of addition holds as an identity of polynomials.
/// A logarithm rests on its operand being positive.
Scalar elementary(const std::string& function, const Scalar& x, Numbers&);

/// log(x), if x is a product of exponentials and a positive rational.
std::optional<Scalar> exponent(const Scalar& x, Numbers&);

/// Positive wherever it has a value, for it is an exponential.
bool is_exponential(const Formula&);

}  // namespace seam::claims
