// SPDX-License-Identifier: GPL-3.0-or-later
#include "bernstein/extremum.h"

#include <gtest/gtest.h>

#include "bernstein/refine.h"

namespace seam::bernstein {
namespace {

using exact::Polynomial;
using exact::Rational;
using exact::RingPtr;

struct Maximum : testing::Test {
  RingPtr ring = exact::Ring::make(nullptr, {"u", "v"});
  Polynomial u = ring->variable(0), v = ring->variable(1);
  Polynomial q(long a, long b = 1) {
    Rational r(a, b);
    r.canonicalize();
    return ring->constant(r);
  }
};

TEST_F(Maximum, is_found_at_the_centre) {
  const Landscape f(u * v * (q(1) - u - v), q(1), {2});
  const auto found = f.highest();
  ASSERT_FALSE(found.empty());
  EXPECT_TRUE(found[0].is_centre);
  EXPECT_EQ(found[0].face, Face{7});
  EXPECT_NEAR(found[0].value, 1.0 / 27, 1e-12);
}

TEST_F(Maximum, is_found_at_all_three_corners) {
  const Polynomial w = q(1) - u - v;
  const auto found = Landscape(u * u + v * v + w * w, q(1), {2}).highest();
  ASSERT_EQ(found.size(), 3U);
  for (const Spot& spot : found) EXPECT_TRUE(spot.at.empty());
}

TEST_F(Maximum, of_a_quotient_on_a_square_is_found) {
  const Polynomial f = q(1) + (u - q(1, 2)) * (u - q(1, 2)) + (v - q(1, 4)) * (v - q(1, 4));
  const auto found = Landscape(q(1), f, {1, 1}).highest();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].at[0], 0.5, 1e-9);
  EXPECT_NEAR(found[0].at[1], 0.25, 1e-9);
}

TEST_F(Maximum, within_an_edge_is_found) {
  const auto found = Landscape(u - u * u * u - v, q(1), {2}).highest();  // u = 1/sqrt(3), v = 0
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].face, Face{3});
  EXPECT_NEAR(found[0].at[0], 0.5773502691896, 1e-9);
}

TEST_F(Maximum, at_two_points_inside_is_found_at_both) {
  const Polynomial g = (u - q(1, 5)) * (u - q(2, 5)), h = v - q(1, 3);
  const auto found = Landscape(q(1) - g * g - h * h, q(1), {2}).highest();
  ASSERT_EQ(found.size(), 2U);
}

TEST_F(Maximum, in_a_box_of_three_dimensions_is_found) {
  const RingPtr space = exact::Ring::make(nullptr, {"x", "y", "z"});
  Polynomial f = space->constant(1);
  for (int i = 0; i < 3; ++i) {
    const Polynomial g = space->variable(i) - space->constant(Rational(1, 3 + i));
    f = f - g * g;
  }
  const auto found = Landscape(f, space->constant(1), {1, 1, 1}).highest();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].at[2], 0.2, 1e-9);
}

TEST_F(Maximum, restricted_to_an_edge_is_a_function_of_one_share) {
  const auto edge = Landscape(u + q(2) * v, q(1), {2}).on({6});  // from (1, 0) to (0, 1)
  const RingPtr line = exact::Ring::make(nullptr, {"t0"});
  EXPECT_EQ(line->embed(edge.numerator), line->constant(1) + line->variable(0));
}

TEST_F(Maximum, is_located_to_many_digits) {
  const RingPtr line = exact::Ring::make(nullptr, {"t"});
  const Polynomial t = line->variable(0);
  const auto at = refined(t, line->constant(1) + t * t * t, {0.7937}, 400);  // 1/cbrt(2)
  ASSERT_TRUE(at);
  const Rational x = (*at)[0];
  EXPECT_LT(abs(2 * x * x * x - 1), Rational(1, exact::Integer(1) << 380));
}

}  // namespace
}  // namespace seam::bernstein
