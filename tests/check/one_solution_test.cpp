// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <gtest/gtest.h>

#include "builder.h"

namespace seam::check::test {
namespace {

// 2 x - 1 = 0 and 2 y - 1 = 0 on the unit square.
struct OneSolutionRule : testing::Test {
  Case k;
  Term x = k.symbol("x"), y = k.symbol("y"), one = k.number(1);
  Term f = k.difference(k.scaled(2, x), one), g = k.difference(k.scaled(2, y), one);
  OneSolution stated{{f, g},
                     {"x", "y"},
                     {},
                     {{k.segment("x"), k.segment("y")}, {}},
                     {"49/100", "49/100"},
                     {"51/100", "51/100"}};

  // The outer box holds the domain, so that the cover is plain.
  Isolation shown{{{"1", "0"}, {"0", "1"}},
                  {{"499/1000", "499/1000"}, {"501/1000", "501/1000"}},
                  {{"-1", "-1"}, {"2", "2"}},
                  std::vector<Pieces>(4, pieces({plain()})),
                  {},
                  std::vector<Pieces>(4, pieces({plain()})),
                  std::vector<Pieces>(4, pieces({plain()}))};

  Finding found() {
    k.claim(stated);
    return k.finding(shown);
  }
};

TEST_F(OneSolutionRule, boxes_show_one_solution) {
  EXPECT_HOLDS(found());
}

TEST_F(OneSolutionRule, the_inner_box_lies_in_that_of_the_statement) {
  stated.high = {"1/2", "51/100"};
  EXPECT_OPEN(found(), "not in that of the statement");
}

TEST_F(OneSolutionRule, an_inner_box_apart_refutes) {
  stated.low = {"6/10", "49/100"};
  stated.high = {"7/10", "51/100"};
  EXPECT_FAILS(found());
}

TEST_F(OneSolutionRule, an_inner_box_that_touches_does_not_refute) {
  stated.low = {"501/1000", "49/100"};
  stated.high = {"7/10", "51/100"};
  EXPECT_OPEN(found(), "not in that of the statement");
}

TEST_F(OneSolutionRule, a_face_with_the_wrong_sign_is_rejected) {
  shown.inner.low[0] = "5001/10000";
  EXPECT_OPEN(found(), "do not show the sign");
}

TEST_F(OneSolutionRule, a_face_on_which_it_touches_0_is_rejected) {
  shown.inner.low[0] = "1/2";
  EXPECT_OPEN(found(), "do not show the sign");
}

TEST_F(OneSolutionRule, a_combination_is_invertible) {
  shown.combination = {{"1", "0"}, {"1", "0"}};
  EXPECT_OPEN(found(), "not invertible");
}

TEST_F(OneSolutionRule, an_exchanged_combination_is_rejected) {
  shown.combination = {{"0", "1"}, {"1", "0"}};
  EXPECT_OPEN(found(), "do not show the sign");
}

TEST_F(OneSolutionRule, there_are_as_many_equations_as_unknowns) {
  stated.system = {f};
  EXPECT_OPEN(found(), "not as many equations");
}

TEST_F(OneSolutionRule, the_outer_box_holds_the_inner_one) {
  shown.outer.low[0] = "1/2";
  EXPECT_OPEN(found(), "not in the outer one");
}

TEST_F(OneSolutionRule, what_the_outer_box_leaves_out_is_to_be_excluded) {
  shown.outer.low[0] = "1/4";
  EXPECT_OPEN(found(), "do not show the sign");
  // [0, 1] is halved, and its left half again; where x <= 1/4, F_1 < 0. Part 0 is the right
  // one.
  const std::vector<Term> middle = {one, one};
  shown.cover[0] = pieces({split(0, middle), plain(), split(0, middle), plain(), outside(0)});
  EXPECT_HOLDS(found());
  shown.cover[0].steps.back() = outside(1);
  EXPECT_OPEN(found(), "not seen to be broken");
}

TEST_F(OneSolutionRule, the_inner_box_lies_in_the_domain) {
  stated.domain.factors[0] = k.segment("x", "1/2", "1");
  EXPECT_OPEN(found(), "leaves the domain");
}

TEST_F(OneSolutionRule, a_condition_holds_all_over_the_inner_box) {
  stated.domain.where = {{k.difference(x, y), Relation::nonnegative}};
  EXPECT_OPEN(found(), "not one tree for each condition");
  shown.conditions = {pieces({plain()})};
  EXPECT_OPEN(found(), "do not show the sign");
  stated.domain.where = {{x, Relation::positive}};
  EXPECT_HOLDS(found());
}

TEST_F(OneSolutionRule, rows_that_are_not_dominant_are_rejected) {
  stated.system = {k.sum({f, k.scaled(2, g)}), g};
  EXPECT_OPEN(found(), "do not show the sign");
}

TEST_F(OneSolutionRule, a_root_of_a_function_has_no_place_in_it) {
  k.statement.functions = {{"s", k.difference(x, y), 2}};
  stated.system = {k.sum({f, k.symbol("s"), k.scaled(-1, k.symbol("s"))}), g};
  EXPECT_OPEN(found(), "a system with functions");
}

TEST_F(OneSolutionRule, no_solution_at_all_refutes) {
  stated.system = {k.sum({x, one}), g};
  shown = {};
  shown.cover = {pieces({outside(0)})};
  EXPECT_FAILS(found());
  stated.system = {f, g};
  EXPECT_OPEN(found(), "not seen to be broken");
}

}  // namespace
}  // namespace seam::check::test
