// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "symbolic/formula.h"
#include "symbolic/numbers.h"

namespace seam::claims {

using symbolic::Formula;
using symbolic::Numbers;

/// A real number or function as a quotient of formulas. It has a value only where none of
/// `divisors` is 0: everything that was ever divided by on the way and holds a
/// variable, even where it cancels or is multiplied by 0. Quotients of numbers are
/// worked out at once (`Numbers::inverse`), so they leave no divisor.
struct Scalar {
  Formula numerator = 0;
  Formula denominator = 1;
  std::vector<Formula> divisors;

  Scalar() = default;
  Scalar(long value) : numerator(value) {}
  Scalar(Formula formula) : numerator(std::move(formula)) {}

  bool is_polynomial() const { return denominator.is(1) && divisors.empty(); }
};

/// A quotient by 0 was asked for.
struct DivisionByZero : symbolic::NumberError {
  DivisionByZero() : NumberError("division by zero") {}
};

Scalar operator+(const Scalar&, const Scalar&);
Scalar operator-(const Scalar&, const Scalar&);
Scalar operator-(const Scalar&);
Scalar operator*(const Scalar&, const Scalar&);
/// Throws `DivisionByZero` when b is 0 identically as written or as a number.
Scalar divide(const Scalar& a, const Scalar& b, Numbers&);
/// Any integer exponent of at most 1000 in size; throws `NumberError` beyond.
Scalar power(const Scalar& base, long exponent, Numbers&);

/// Symbols replaced by quotients, in numerator, denominator and divisors.
Scalar substitute(const Scalar&, const std::map<std::string, Scalar>&, Numbers&);

bool is_number(const Scalar&);

}  // namespace seam::claims
