// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/linear_program.h"

#include <gtest/gtest.h>

namespace seam::prove {
namespace {

using exact::Rational;
using Rows = std::vector<std::vector<Rational>>;

TEST(LinearProgram, finds_where_the_last_unknown_is_greatest) {
  // y <= 2 x, x + y <= 3
  const auto x = linear_program(Rows{{-2, 1}, {1, 1}}, {0, 3});
  ASSERT_TRUE(x);
  EXPECT_EQ(*x, (std::vector<Rational>{1, 2}));
}

TEST(LinearProgram, begins_where_the_origin_breaks_a_row) {
  // x >= 1, x <= 4, y <= 5 - x
  const auto x = linear_program(Rows{{-1, 0}, {1, 0}, {1, 1}}, {-1, 4, 5});
  ASSERT_TRUE(x);
  EXPECT_EQ(*x, (std::vector<Rational>{1, 4}));
}

TEST(LinearProgram, says_nothing_where_no_point_meets_all_rows) {
  EXPECT_FALSE(linear_program(Rows{{-1, 0}, {1, 0}}, {-2, 1}));
}

TEST(LinearProgram, ends_where_a_method_without_a_rule_goes_round) {
  const Rational half(1, 2);
  const Rows rows = {{half, Rational(-11, 2), Rational(-5, 2), 9, 0},
                     {half, Rational(-3, 2), -half, 1, 0},
                     {1, 0, 0, 0, 0},
                     {-10, 57, 9, 24, 1}};
  const auto x = linear_program(rows, {0, 0, 1, 0});
  ASSERT_TRUE(x);
  EXPECT_EQ(x->back(), 1);
}

}  // namespace
}  // namespace seam::prove
