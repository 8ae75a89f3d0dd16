// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "exact/contract.h"
#include "exact/recognise.h"
#include "exact/roots.h"
#include "exact/square.h"

namespace seam::exact {
namespace {

Univariate with_integers(const RingPtr& ring, std::vector<long> coefficients) {
  Univariate result;
  for (const long c : coefficients) result.push_back(ring->constant(c));
  return result;
}

TowerPtr root_of(TowerPtr below, std::vector<long> coefficients, const std::string& name,
                 Rational low, Rational high) {
  const Univariate f = with_integers(Ring::make(below, {}), std::move(coefficients));
  return adjoin(f, name, bracket(f, {low, high}));
}

struct OverRoot5 : testing::Test {
  TowerPtr tower = root_of(nullptr, {-5, 0, 1}, "s", 0, 5);
  RingPtr ring = Ring::make(tower, {});
  Polynomial s = *ring->symbol("s");
  Polynomial q(long a) { return ring->constant(a); }
};

TEST_F(OverRoot5, powers_of_the_generator_are_reduced) {
  EXPECT_EQ((s * s).rational(), Rational(5));
  EXPECT_EQ((s.pow(4)).rational(), Rational(25));
}

TEST_F(OverRoot5, signs_are_those_of_the_positive_root) {
  EXPECT_EQ(sign(s), Sign::positive);
  EXPECT_EQ(sign(s - q(2)), Sign::positive);
  EXPECT_EQ(sign(s - q(3)), Sign::negative);
  EXPECT_EQ(sign(s * s - q(5)), Sign::zero);
}

TEST_F(OverRoot5, factors_over_the_field) {
  // x^4 - 5 has the factor x^2 - s; x^2 - 6 - 2 s has x - 1 - s.
  Univariate f = with_integers(ring, {-5, 0, 0, 0, 1});
  EXPECT_EQ(degree(irreducible_factor(f, {1, 2})), 2);
  f = {-q(6) - q(2) * s, q(0), q(1)};
  const Univariate linear = irreducible_factor(f, {3, 4});
  EXPECT_EQ(degree(linear), 1);
  EXPECT_TRUE((linear[0] + q(1) + s).is_zero());
  EXPECT_EQ(degree(irreducible_factor(with_integers(ring, {-7, 0, 1}), {2, 3})), 2);
}

TEST_F(OverRoot5, a_number_is_recognised_by_its_digits) {
  const Polynomial x = Rational(3, 7) * s - q(2);
  const auto e = enclosure(x, 250);
  const auto found = recognise(ring, e.low, 220);
  ASSERT_TRUE(found);
  EXPECT_TRUE(*found == x);
}

TEST_F(OverRoot5, a_random_number_is_not_recognised) {
  const TowerPtr other = root_of(nullptr, {-1, -1, 0, 0, 0, 1}, "r", 1, 2);
  const auto e = enclosure(*Ring::make(other, {})->symbol("r"), 250);
  EXPECT_FALSE(recognise(ring, e.low, 220));
}

TEST_F(OverRoot5, a_square_factor_is_found_up_to_a_number) {
  const RingPtr plane = Ring::make(tower, {"x", "y"});
  const Polynomial x = plane->variable(0), y = plane->variable(1), t = *plane->symbol("s");
  const Polynomial root = x - Rational(2) * y;
  const auto found = square_factor(t * root * root * (x + y));
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->root * found->root * found->cofactor == t * root * root * (x + y));
  EXPECT_FALSE(square_factor(x * y * (x + y)));
}

TEST_F(OverRoot5, the_inverse_of_zero_is_a_broken_contract) {
  EXPECT_THROW(inverse(s - s), ContractError);
}

TEST(Towers, a_generator_need_not_be_integral) {
  const Univariate f = with_integers(Ring::make(nullptr, {}), {-1, -1, 0, 3});  // 3 x^3 - x - 1
  const TowerPtr tower = adjoin(monic(f), "g", bracket(f, {0, 2}));
  const Polynomial g = *Ring::make(tower, {})->symbol("g");
  EXPECT_TRUE((Rational(3) * g.pow(3) - g - g.ring().constant(1)).is_zero());
  EXPECT_NEAR(ball(g).middle, 0.851383, 1e-6);
}

TEST(Roots, of_a_cubic_are_isolated) {
  const RingPtr ring = Ring::make(nullptr, {});
  const Univariate f = with_integers(ring, {1, -3, 0, 1});
  EXPECT_EQ(real_roots(f).size(), 3U);
  EXPECT_EQ(real_roots(f, 0, 1).size(), 1U);
  EXPECT_EQ(real_roots(with_integers(ring, {1, 0, 1})).size(), 0U);
}

TEST(Roots, at_the_ends_of_an_interval_count) {
  const RingPtr ring = Ring::make(nullptr, {});
  const Univariate f = with_integers(ring, {0, 2, -3, 1});  // x (x - 1) (x - 2)
  EXPECT_EQ(real_roots(f, 0, 2).size(), 3U);
  EXPECT_EQ(real_roots(f, 1, 1).size(), 1U);
}

TEST(Fractions, the_simplest_is_found) {
  EXPECT_EQ(simplest(Rational(0.333333333), Rational(1, 1000000)), Rational(1, 3));
  EXPECT_EQ(simplest(Rational(-0.75), Rational(1, 1000000)), Rational(-3, 4));
  EXPECT_EQ(simplest(Rational(1e-9), Rational(1, 1000000)), 0);
}

TEST(Recognise, a_polynomial_that_a_decimal_nearly_satisfies_is_found) {
  const RingPtr rationals = Ring::make(nullptr, {});
  const Univariate f = with_integers(rationals, {-2, 0, 0, 1});  // the cube root of 2
  RootInterval root = real_roots(f).front();
  while (root.high - root.low > Rational(1, Integer(1) << 320)) root = halved(f, root);
  const auto found = annihilator(rationals, root.low, 6, 300);
  ASSERT_TRUE(found);
  EXPECT_EQ(monic(*found), f);
  EXPECT_FALSE(annihilator(rationals, root.low, 2, 300));
}

}  // namespace
}  // namespace seam::exact
