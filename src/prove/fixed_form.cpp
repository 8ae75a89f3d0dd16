// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/fixed_form.h"

#include <algorithm>

#include "exact/field.h"

// A coefficient c in front of l^a is the Bernstein coefficient c * a! / d!, d the degree. A
// halving is de Casteljau's algorithm: the coefficient of an index with e units of the corner
// that is replaced goes through e rounds, each the mean with the one that has a unit moved.

namespace seam::prove {
namespace {

using exact::Integer;
using exact::Rational;

Integer factorial(int n) {
  Integer result;
  mpz_fac_ui(result.get_mpz_t(), static_cast<unsigned long>(n));
  return result;
}

Integer floor_fixed(const Rational& value) {
  Integer result = value.get_num() << FixedForm::bits;
  mpz_fdiv_q(result.get_mpz_t(), result.get_mpz_t(), value.get_den().get_mpz_t());
  return result;
}

Integer ceil_fixed(const Rational& value) {
  Integer result = value.get_num() << FixedForm::bits;
  mpz_cdiv_q(result.get_mpz_t(), result.get_mpz_t(), value.get_den().get_mpz_t());
  return result;
}

}  // namespace

FixedForm::FixedForm(const Barycentric& f) : shape_(f.shape), coefficients_(f.shape->count()) {
  const auto numerators = f.polynomial.numerators();
  for (const auto& [exponents, number] : numerators.terms) {
    std::vector<std::vector<int>> by_factor;
    Rational weight(1, numerators.denominator);
    auto next = exponents.begin();
    for (int k = 0; k < shape_->factors(); ++k) {
      by_factor.emplace_back(next, next + shape_->corners(k));
      next += shape_->corners(k);
      for (const int exponent : by_factor.back()) weight *= factorial(exponent);
      weight /= factorial(shape_->degree(k));
    }
    const auto [low, high] = exact::enclosure(f.polynomial.ring().tower(), number, bits);
    coefficients_[shape_->index(by_factor)] = {floor_fixed(low * weight),
                                               ceil_fixed(high * weight)};
  }
}

FixedForm FixedForm::half(int factor, int replaced, int kept) const {
  FixedForm result = *this;
  for (int round = 1; round <= shape_->degree(factor); ++round)
    for (const auto& [index, exponent] : shape_->ranked(factor, replaced)) {
      if (exponent < round) break;
      auto& [low, high] = result.coefficients_[index];
      const Interval& other =
          result.coefficients_[shape_->moved(index, factor, replaced, kept)];
      low += other.low;
      high += other.high;
      mpz_fdiv_q_2exp(low.get_mpz_t(), low.get_mpz_t(), 1);
      mpz_cdiv_q_2exp(high.get_mpz_t(), high.get_mpz_t(), 1);
    }
  return result;
}

}  // namespace seam::prove
