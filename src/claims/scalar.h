// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "symbolic/formula.h"
#include "symbolic/numbers.h"

namespace seam::claims {

using symbolic::Formula;
using symbolic::Numbers;

/// A real number or function as a quotient of formulas without inverses. It has a value only
/// where none of `divisors` is 0 and none of `radicands` is negative: everything that was ever
/// divided by, or taken an even root of, on the way and holds a variable, even where it cancels
/// or is multiplied by 0. Quotients and roots of algebraic numbers are worked out at once
/// (`Numbers`), so they leave neither. Elementary functions stand in the formulas as `applied`;
/// an exponential is nowhere 0, so it may be divided by.
struct Scalar {
  Formula numerator = 0;
  Formula denominator = 1;
  std::vector<Formula> divisors, radicands;

  Scalar() = default;
  Scalar(long value) : numerator(value) {}
  /// Requires a formula without inverses, roots and logarithms; else see `scalar_of`.
  Scalar(Formula formula) : numerator(std::move(formula)) {}

  /// A polynomial that has a value everywhere.
  bool is_polynomial() const;
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
/// The root >= 0 (of a number and odd n: the real one). n >= 2, even for a function.
Scalar nth_root(const Scalar& radicand, int n, Numbers&);
/// |x|; of a function, the root of its square.
Scalar absolute(const Scalar& x, Numbers&);
/// E, if x is |E| as `absolute` writes it.
std::optional<Scalar> inside_absolute(const Scalar& x);

/// Symbols replaced by quotients, in numerator, denominator, divisors and radicands.
Scalar substitute(const Scalar&, const std::map<std::string, Scalar>&, Numbers&);

/// Any formula as a quotient without inverses, and the formula of a quotient.
Scalar scalar_of(const Formula&, Numbers&);
Formula formula_of(const Scalar&);

bool is_number(const Scalar&);

}  // namespace seam::claims
