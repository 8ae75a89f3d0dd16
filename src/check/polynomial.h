// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include <boost/multiprecision/cpp_int.hpp>
#include <map>
#include <string>

#include "check/meter.h"

namespace seam::check {

/// Without expression templates: every intermediate result is a value.
using Integer = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                              boost::multiprecision::et_off>;

/// How many 64-bit words it takes, at most.
std::size_t limbs(const Integer& n);

/// Place i holds the exponent of symbol i. No zeros at the end, so that equal
/// monomials are equal strings.
using Monomial = std::u16string;

/// (sum of integer * monomial) / denominator. No coefficient is 0; denominator > 0.
struct Polynomial {
  std::map<Monomial, Integer> terms;
  Integer denominator = 1;

  bool is_zero() const { return terms.empty(); }
  /// Whether it holds symbols below `count` alone.
  bool is_within(int count) const;
  bool is_rational() const { return is_within(0); }
};

Polynomial constant(const Integer& numerator, const Integer& denominator = 1);
/// symbol^exponent, exponent >= 1.
Polynomial symbol(int index, int exponent = 1);

/// Of the form -?digits(/digits)?, without leading zeros.
Polynomial parse_rational(const std::string& text, Meter& meter);

int exponent(const Monomial& monomial, int index);
/// -1 for the polynomial 0.
int degree(const Polynomial& p, int index);
/// An estimate, from above, of the memory it takes.
std::size_t words(const Polynomial& p);

Polynomial negated(Polynomial p);
void add(Polynomial& to, const Polynomial& p, Meter& meter);
/// The product as it stands: nothing is reduced.
Polynomial multiply(const Polynomial& a, const Polynomial& b, Meter& meter);
Polynomial derivative(const Polynomial& p, int index, Meter& meter);

/// p = sum over e of result[e] * symbol^e. No entry is 0.
std::map<int, Polynomial> by_exponent(const Polynomial& p, int index, Meter& meter);
/// p = sum over m of result[m] * m, m a monomial in the symbols from `first` on, result[m] in
/// those below.
std::map<Monomial, Polynomial> by_monomial(const Polynomial& p, int first, Meter& meter);

}  // namespace seam::check
