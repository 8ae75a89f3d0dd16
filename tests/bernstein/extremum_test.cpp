// SPDX-License-Identifier: GPL-3.0-or-later
#include "bernstein/extremum.h"

#include <gtest/gtest.h>

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

TEST_F(Maximum, at_the_centre) {
  const Polynomial f = u * v * (q(1) - u - v);
  const auto found = maximum(f, q(1), Patch::triangle);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].at[0], Rational(1, 3));
  EXPECT_EQ(found[0].at[1], Rational(1, 3));
  EXPECT_TRUE(found[0].is_critical);
  EXPECT_NEAR(found[0].value, 1.0 / 27, 1e-12);
}

TEST_F(Maximum, at_all_three_corners) {
  const Polynomial w = q(1) - u - v;
  EXPECT_EQ(maximum(u * u + v * v + w * w, q(1), Patch::triangle).size(), 3U);
}

TEST_F(Maximum, of_a_quotient_on_a_square) {
  const Polynomial f = q(1) + (u - q(1, 2)) * (u - q(1, 2)) + (v - q(1, 4)) * (v - q(1, 4));
  const auto found = maximum(q(1), f, Patch::square);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].at[0], Rational(1, 2));
  EXPECT_EQ(found[0].at[1], Rational(1, 4));
  EXPECT_TRUE(found[0].is_critical);
}

TEST_F(Maximum, within_an_edge_at_a_root) {
  const Polynomial f = u - u * u * u - v;  // u = 1/sqrt(3), v = 0
  const auto found = maximum(f, q(1), Patch::triangle);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_FALSE(found[0].is_critical);
  ASSERT_TRUE(found[0].on_edge);
  EXPECT_NEAR(found[0].on_edge->root.low.get_d(), 0.5773502691896, 1e-9);
}

}  // namespace
}  // namespace seam::bernstein
