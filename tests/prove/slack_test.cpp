// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/slack.h"

#include "drafting.h"

namespace seam::prove {
namespace {

using certificate::Relation;
using certificate::Sign;
using exact::Rational;

struct Slacks : testing::Test {
  Draft d;
  T u = d.symbol("u"), v = d.symbol("v");

  Slack of(const Sign& sign, certificate::Term scale = -1) {
    d.statement.obligations = {sign};
    return slacks(d.statement, {{0, scale}}).at(0);
  }
  Slack on_segment(T f, Relation relation, bool open_low = false) {
    return of(Sign{f.term, relation, {{d.segment("u", "0", "1", open_low)}, {}}});
  }
};

void expect_near(const Slack& slack, const Rational& least) {
  ASSERT_EQ(slack.unknown, "");
  ASSERT_TRUE(slack.high);
  EXPECT_LE(slack.low, least);
  EXPECT_GE(*slack.high, least);
  EXPECT_LE(*slack.high - slack.low, least / 100);
}

TEST_F(Slacks, the_least_value_inside_a_segment_is_enclosed) {
  // (u - 1/3)^2 + 1/50
  const T f = ((3 * u - 1) ^ 2) * d.number("1/9") + d.number("1/50");
  expect_near(on_segment(f, Relation::positive), Rational(1, 50));
}

TEST_F(Slacks, the_least_value_at_a_corner_is_exact) {
  const Slack slack = on_segment(u + d.number("1/7"), Relation::positive);
  expect_near(slack, Rational(1, 7));
  ASSERT_EQ(slack.at.size(), 1U);
  EXPECT_EQ(slack.at[0].variable, "u");
  EXPECT_EQ(slack.at[0].high, 0);
}

TEST_F(Slacks, what_is_below_0_is_measured_from_above) {
  expect_near(on_segment(u - 3, Relation::negative), Rational(2));
}

TEST_F(Slacks, where_a_formula_touches_0_the_slack_is_0) {
  const Slack corner = on_segment(u * u, Relation::nonnegative);
  EXPECT_EQ(corner.high, Rational(0));
  const Slack middle = on_segment((2 * u - 1) ^ 2, Relation::nonnegative);
  EXPECT_EQ(middle.high, Rational(0));
  EXPECT_EQ(middle.at.at(0).low, Rational(1, 2));
}

TEST_F(Slacks, an_end_that_is_left_out_is_not_attained) {
  const Slack slack = on_segment(u, Relation::positive, true);
  EXPECT_EQ(slack.low, 0);
  ASSERT_TRUE(slack.high);
  EXPECT_GT(*slack.high, 0);
}

TEST_F(Slacks, a_scale_is_divided_by) {
  // (2 + u) / (1 + u)^2 >= 3/4
  const Sign sign{(u + 2).term, Relation::positive, {{d.segment("u", "0", "1")}, {}}};
  expect_near(of(sign, ((u + 1) ^ 2).term), Rational(3, 4));
}

TEST_F(Slacks, a_ray_without_end_is_covered) {
  // (2u + 3) / (u + 1) > 2
  const Sign sign{(2 * u + 3).term, Relation::positive, {{d.from_zero("u")}, {}}};
  const Slack slack = of(sign, (u + 1).term);
  EXPECT_EQ(slack.unknown, "");
  EXPECT_GE(slack.low, Rational(19, 10));
  EXPECT_LE(slack.low, 2);
}

TEST_F(Slacks, a_number_is_enclosed) {
  const T root = d.generator("sqrt(5)", (d.symbol("sqrt(5)") ^ 2) - 5, "2", "3");
  const Slack slack = of(Sign{(root - 2).term, Relation::positive, {}});
  EXPECT_LT(slack.low, Rational(2360680, 10000000));
  EXPECT_GT(slack.low, Rational(2360679, 10000000));
  EXPECT_TRUE(slack.at.empty());
}

TEST_F(Slacks, conditions_cut_off_what_lies_outside) {
  Sign sign{u.term, Relation::positive, {{d.segment("u", "0", "1")}, {}}};
  sign.domain.where = {{(2 * u - 1).term, Relation::nonnegative}};
  expect_near(of(sign), Rational(1, 2));
}

TEST_F(Slacks, that_nothing_meets_the_conditions_is_said) {
  Sign sign{u.term, Relation::positive, {{d.segment("u", "0", "1")}, {}}};
  sign.domain.where = {{(u - 2).term, Relation::positive}};
  EXPECT_EQ(of(sign).unknown, no_point);
  sign.relation = Relation::zero;
  EXPECT_EQ(of(sign).unknown, no_point);
}

TEST_F(Slacks, a_formula_over_a_triangle_is_measured) {
  // 1 - u v >= 3/4
  const Sign sign{(1 - u * v).term, Relation::positive, {{d.triangle()}, {}}};
  expect_near(of(sign), Rational(3, 4));
}

}  // namespace
}  // namespace seam::prove
