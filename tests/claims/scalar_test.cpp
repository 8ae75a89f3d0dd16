// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/scalar.h"

#include <gtest/gtest.h>

#include "symbolic/coefficients.h"
#include "symbolic/denominator.h"

namespace seam::claims {
namespace {

using symbolic::vanishes;

const Formula c = Formula::symbol("c"), d = Formula::symbol("d");
Formula four() {
  return Formula(4) - Formula(3) * symbolic::power(c, 2);
}

TEST(ScalarFunction, SumsHaveTheLeastCommonDenominatorOfFactorsAsWritten) {
  Numbers numbers;
  const Scalar a = divide(Scalar(1), Scalar(Formula(3) * four()), numbers);
  const Scalar b = divide(Scalar(1), Scalar(symbolic::power(c, 2) * four()), numbers);
  const Scalar sum = a + b;
  EXPECT_TRUE(vanishes(sum.denominator - symbolic::power(c, 2) * four(), numbers));
}

TEST(ScalarFunction, ADivisorIsRememberedThoughTheQuotientIsZero) {
  Numbers numbers;
  const Scalar zero = Scalar(0) * divide(Scalar(1), Scalar(c), numbers);
  ASSERT_EQ(zero.divisors.size(), 1u);
  const Scalar again = scalar_of(formula_of(zero), numbers);
  ASSERT_EQ(again.divisors.size(), 1u);
  EXPECT_TRUE(again.divisors.front().same(c));
}

TEST(ScalarFunction, ARadicandIsRememberedThoughTheRootIsMultipliedByZero) {
  Numbers numbers;
  const Scalar zero = Scalar(0) * nth_root(Scalar(c), 2, numbers);
  ASSERT_EQ(zero.radicands.size(), 1u);
  EXPECT_EQ(scalar_of(formula_of(zero), numbers).radicands.size(), 1u);
}

TEST(ScalarFunction, TheRootOfAQuotientIsARootOverASize) {
  Numbers numbers;
  const Scalar root = nth_root(divide(Scalar(d), Scalar(c), numbers), 2, numbers);
  EXPECT_TRUE(root.radicands.front().same(d * c));
  EXPECT_TRUE(vanishes(symbolic::power(root.denominator, 2) - symbolic::power(c, 2), numbers));
  EXPECT_EQ(root.denominator.kind(), Formula::Kind::root) << "c may be negative";
}

TEST(ScalarFunction, ARootBecomesANumberWhenItsVariablesDo) {
  Numbers numbers;
  const Scalar root = nth_root(Scalar(Formula(1) - symbolic::power(c, 2)), 2, numbers);
  const Scalar value =
      substitute(root, {{"c", Scalar(Formula(exact::Rational(3, 5)))}}, numbers);
  ASSERT_TRUE(is_number(value));
  EXPECT_EQ(numbers.rational(value.numerator), exact::Rational(4, 5));
}

TEST(ScalarFunction, ARootOfANegativeNumberIsRefusedWhenTheVariablesBecomeNumbers) {
  Numbers numbers;
  const Scalar root = nth_root(Scalar(c), 2, numbers);
  EXPECT_THROW(substitute(root, {{"c", Scalar(-1)}}, numbers), symbolic::NumberError);
  EXPECT_THROW(substitute(Scalar(0) * root, {{"c", Scalar(-1)}}, numbers),
               symbolic::NumberError);
}

TEST(ScalarFunction, DivisionByZeroIsRefusedWhenTheVariablesBecomeNumbers) {
  Numbers numbers;
  const Scalar quotient = divide(Scalar(c), Scalar(c), numbers);
  EXPECT_THROW(substitute(quotient, {{"c", Scalar(0)}}, numbers), DivisionByZero);
}

TEST(ScalarFunction, TheSizeOfAFunctionIsTheRootOfItsSquare) {
  Numbers numbers;
  const Scalar size = absolute(Scalar(c - d), numbers);
  const auto inside = inside_absolute(size);
  ASSERT_TRUE(inside.has_value());
  EXPECT_TRUE(vanishes(inside->numerator - c + d, numbers));
  EXPECT_FALSE(inside_absolute(Scalar(c)).has_value());
  EXPECT_FALSE(inside_absolute(-size).has_value());
}

}  // namespace
}  // namespace seam::claims
