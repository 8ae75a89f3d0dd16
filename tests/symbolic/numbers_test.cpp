// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/numbers.h"

#include <gtest/gtest.h>

#include "exact/contract.h"

namespace seam::symbolic {
namespace {

using exact::Rational;
using exact::Sign;

Formula q(long a, long b) {
  Rational r(a, b);
  r.canonicalize();
  return Formula(r);
}

TEST(Numbers, a_square_factor_leaves_the_root) {
  Numbers numbers;
  EXPECT_EQ(text(numbers.normal_form(numbers.sqrt(20))), "2*sqrt(5)");
  EXPECT_EQ(numbers.generators().size(), 1U);
}

TEST(Numbers, a_root_of_a_fraction_makes_an_integral_generator) {
  Numbers numbers;
  EXPECT_TRUE(numbers.equal(numbers.sqrt(q(1, 3)), q(1, 3) * numbers.sqrt(3)));
  ASSERT_EQ(numbers.generators().size(), 1U);
  EXPECT_EQ(numbers.generators()[0].name, "sqrt(3)");
  EXPECT_EQ(text(numbers.generators()[0].polynomial), "sqrt(3)^2 - 3");
  EXPECT_EQ(numbers.generators()[0].low, 1);
  EXPECT_EQ(numbers.generators()[0].high, 2);
}

TEST(Numbers, a_root_of_a_quadratic_is_written_with_a_square_root) {
  Numbers numbers;
  const Formula x = Formula::symbol("x");
  const Formula upper = numbers.root(power(x, 2) - x - Formula(1), "x", 0, 2);
  const Formula lower = numbers.root(power(x, 2) - x - Formula(1), "x", -1, 0);
  EXPECT_EQ(text(numbers.normal_form(upper)), "(1/2)*sqrt(5) + 1/2");
  EXPECT_TRUE(numbers.equal(upper + lower, 1));
  EXPECT_TRUE(numbers.equal(upper * lower, -1));
  EXPECT_EQ(numbers.generators().size(), 1U);
}

TEST(Numbers, asking_twice_gives_the_same_number) {
  Numbers numbers;
  const Formula a = numbers.sqrt(5), b = numbers.sqrt(5);
  EXPECT_TRUE(numbers.equal(a, b));
  EXPECT_EQ(numbers.generators().size(), 1U);
}

TEST(Numbers, perfect_squares_make_no_generator) {
  Numbers numbers;
  EXPECT_EQ(numbers.rational(numbers.sqrt(q(9, 4))), Rational(3, 2));
  EXPECT_EQ(numbers.rational(numbers.nth_root(-8, 3)), -2);
  EXPECT_TRUE(numbers.generators().empty());
}

TEST(Numbers, a_dependent_root_is_found_in_the_field) {
  Numbers numbers;
  const Formula r2 = numbers.sqrt(2), r3 = numbers.sqrt(3);
  EXPECT_TRUE(numbers.equal(numbers.sqrt(6), r2 * r3));
  const Formula nested = numbers.sqrt(Formula(5) + Formula(2) * r2 * r3);
  EXPECT_TRUE(numbers.equal(nested, r2 + r3));
  const auto& field = numbers.field(nested * numbers.sqrt(6) * r2);
  EXPECT_EQ(field.generators.size(), 2U);
  EXPECT_EQ(field.dependent.size(), 1U);
}

TEST(Numbers, a_denested_root_is_found_in_the_field) {
  Numbers numbers;
  const Formula r5 = numbers.sqrt(5);
  // sqrt(6 + 2 sqrt 5) = 1 + sqrt 5
  EXPECT_TRUE(numbers.equal(numbers.sqrt(Formula(6) + Formula(2) * r5), Formula(1) + r5));
  EXPECT_EQ(numbers.generators().size(), 1U);
}

TEST(Numbers, conjugate_nested_roots_are_related) {
  Numbers numbers;
  const Formula r5 = numbers.sqrt(5);
  const Formula a = numbers.sqrt(Formula(10) + Formula(2) * r5);
  const Formula b = numbers.sqrt(Formula(10) - Formula(2) * r5);  // a b = 4 sqrt 5
  EXPECT_TRUE(numbers.equal(a * b, Formula(4) * r5));
  EXPECT_EQ(numbers.field(a * b).generators.size(), 2U);
  EXPECT_EQ(numbers.sign(a - b), Sign::positive);
}

TEST(Numbers, a_fourth_root_of_a_square_is_a_square_root) {
  Numbers numbers;
  const Formula r = numbers.nth_root(25, 4);
  EXPECT_TRUE(numbers.equal(r * r, 5));
  EXPECT_EQ(numbers.generators()[0].name, "sqrt(5)");
}

TEST(Numbers, the_root_of_a_negative_number_is_refused) {
  Numbers numbers;
  try {
    numbers.sqrt(q(-16, 5));
    FAIL();
  } catch (const NumberError& error) {
    EXPECT_STREQ(error.what(), "square root of a negative number (about -3.2)");
  }
}

TEST(Numbers, a_number_that_is_nearly_zero_is_not_zero) {
  Numbers numbers;
  const Formula r2 = numbers.sqrt(2);
  Formula tiny = 1;
  for (int i = 0; i < 40; ++i) tiny = tiny * (r2 - Formula(1));
  EXPECT_EQ(numbers.sign(tiny), Sign::positive);
  EXPECT_EQ(numbers.sign(tiny - tiny), Sign::zero);
}

TEST(Numbers, an_inverse_is_one) {
  Numbers numbers;
  const Formula x = numbers.sqrt(2) + numbers.sqrt(3) + numbers.nth_root(5, 3);
  EXPECT_TRUE(numbers.equal(x * numbers.inverse(x), 1));
  EXPECT_THROW(numbers.inverse(x - x), NumberError);
}

TEST(Numbers, the_only_root_in_an_interval) {
  Numbers numbers;
  const Formula g = Formula::symbol("g");
  const Formula f = Formula(3) * power(g, 3) - g - Formula(1);
  const Formula r = numbers.root(f, "g", Rational(4, 5), Rational(6, 5));
  EXPECT_EQ(numbers.decimal(r, 6), "0.851383");
  EXPECT_EQ(numbers.sign(Formula(3) * power(r, 3) - r - Formula(1)), Sign::zero);
  EXPECT_EQ(numbers.generators()[0].name, "root(3*x^3 - x - 1)");
}

TEST(Numbers, no_root_or_several_are_refused) {
  Numbers numbers;
  const Formula x = Formula::symbol("x");
  EXPECT_THROW(numbers.root(x * x - Formula(2), "x", -2, 2), NumberError);
  EXPECT_THROW(numbers.root(x * x - Formula(2), "x", 2, 3), NumberError);
  EXPECT_THROW(numbers.root(Formula(0), "x", 2, 3), NumberError);
}

TEST(Numbers, a_multiple_root_counts_once) {
  Numbers numbers;
  const Formula x = Formula::symbol("x");
  const Formula r = numbers.root(power(x * x - Formula(2), 2), "x", 0, 5);
  EXPECT_TRUE(numbers.equal(r * r, 2));
  EXPECT_TRUE(numbers.equal(r, numbers.sqrt(2)));
  EXPECT_EQ(numbers.field(r - numbers.sqrt(2)).generators.size(), 1U);
}

TEST(Numbers, the_roots_of_one_polynomial_are_told_apart) {
  Numbers numbers;
  const Formula x = Formula::symbol("x");
  const Formula f = power(x, 3) - Formula(3) * x + Formula(1);  // three real roots, one field
  const Formula a = numbers.root(f, "x", 0, 1), b = numbers.root(f, "x", 1, 2);
  EXPECT_EQ(numbers.field(a * b).generators.size(), 1U);
  EXPECT_EQ(numbers.sign(b - a), Sign::positive);
  const Formula g =
      power(x, 3) - Formula(4) * x + Formula(1);  // three real roots, other fields
  const Formula c = numbers.root(g, "x", 0, 1), d = numbers.root(g, "x", 1, 2);
  ASSERT_EQ(numbers.field(c * d).generators.size(), 2U);
  EXPECT_NE(numbers.field(c).generators[0].name, numbers.field(d).generators[0].name);
  EXPECT_EQ(numbers.sign(d - c), Sign::positive);
}

TEST(Numbers, decimals_are_rounded_correctly) {
  Numbers numbers;
  EXPECT_EQ(numbers.decimal(q(1, 8), 2), "0.13");
  EXPECT_EQ(numbers.decimal(q(-1, 8), 2), "-0.13");
  EXPECT_EQ(numbers.decimal(q(-1, 1000), 2), "0.00");
  EXPECT_EQ(numbers.decimal(numbers.sqrt(2), 20), "1.41421356237309504880");
  EXPECT_EQ(numbers.decimal(7, 0), "7");
}

TEST(Numbers, five_independent_roots) {
  Numbers numbers;
  const Formula s = numbers.sqrt(2) + numbers.sqrt(3) + numbers.sqrt(5) + numbers.sqrt(7);
  const Formula nested = numbers.sqrt(s);
  EXPECT_TRUE(numbers.equal(nested * nested, s));
  EXPECT_EQ(numbers.generators().size(), 5U);
  EXPECT_TRUE(numbers.equal(numbers.sqrt(210) * numbers.sqrt(210), 210));
  EXPECT_EQ(numbers.field(nested * numbers.sqrt(210)).generators.size(), 5U);
}

TEST(Numbers, many_independent_roots_do_not_burden_each_other) {
  Numbers numbers;
  std::vector<Formula> all;
  for (const long p : {2, 3, 5, 7, 11, 13, 17, 19, 23, 29}) all.push_back(numbers.sqrt(p));
  EXPECT_EQ(numbers.sign(all[9] - all[8]), Sign::positive);
  EXPECT_EQ(numbers.field(all[9] * all[8]).generators.size(), 2U);
  EXPECT_THROW(numbers.sign(sum(all)), NumberLimit);
}

TEST(Numbers, a_dependent_generator_is_known_by_the_others) {
  Numbers numbers;
  const Formula r6 = numbers.sqrt(6), r2 = numbers.sqrt(2), r3 = numbers.sqrt(3);
  const auto& field = numbers.field(r2 * r3 * r6);
  ASSERT_EQ(field.dependent.size(), 1U);
  const auto& [name, value] = *field.dependent.begin();
  EXPECT_EQ(value.kind(), Formula::Kind::known);
  EXPECT_EQ(value.facts().size(), 3U);
  EXPECT_TRUE(numbers.equal(value, Formula::symbol(name)));
}

TEST(Numbers, a_radical_of_degree_sixteen_is_found_to_be_zero) {
  Numbers numbers;
  const Formula r5 = numbers.sqrt(5), r3 = numbers.sqrt(3);
  const Formula big = numbers.sqrt(Formula(6) * (Formula(556615) + Formula(248877) * r5));
  const Formula c = numbers.sqrt(q(2, 15) * (Formula(5) - r5));
  const Formula sum = big + c + r3;
  EXPECT_TRUE(numbers.equal(power(sum - c - r3, 2),
                            Formula(6) * (Formula(556615) + Formula(248877) * r5)));
  EXPECT_EQ(numbers.sign(sum - big - c - r3 + q(1, 1'000'000'000)), Sign::positive);
}

}  // namespace
}  // namespace seam::symbolic
