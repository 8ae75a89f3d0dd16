// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <gtest/gtest.h>

#include <tuple>
#include <utility>
#include <vector>

#include "on_line.h"

namespace seam::check::test {
namespace {

TEST(Condition, a_condition_that_can_be_met_leaves_no_piece_out) {
  OnLine c({"-1/2", "1"}, Relation::positive);  // x - 1/2
  c.sign().domain.where = {{c.x, Relation::nonnegative}};
  EXPECT_OPEN(c.finding(pieces({c.halved(), plain(), outside(0)})), "");
  EXPECT_OPEN(c.finding(pieces({outside(0)})), "broken");
  EXPECT_OPEN(c.finding(pieces({outside(1)})), "a condition that is none");
}

TEST(Condition, a_condition_that_is_met_at_one_point_leaves_no_piece_out) {
  OnLine c({"0", "1"}, Relation::positive);  // fails at 0, which -x >= 0 leaves in
  c.sign().domain.where = {{c.product({c.x, c.number(-1)}), Relation::nonnegative}};
  EXPECT_OPEN(c.finding(pieces({outside(0)})), "");
}

TEST(Condition, a_piece_where_a_condition_is_broken_needs_no_sign) {
  OnLine c({"-1/2", "1"}, Relation::nonnegative);  // x - 1/2 where x - 1/2 > 0
  c.sign().domain.where = {{c.sign().formula, Relation::positive}};
  EXPECT_HOLDS(c.finding(pieces({c.halved(), plain(), outside(0)})));
  EXPECT_OPEN(c.finding(pieces({c.halved(), outside(0), plain()})), "");
}

TEST(Condition, a_zero_where_a_condition_excludes_zero_does_no_harm) {
  using enum Relation;
  for (const auto& [relation, expected] :
       std::vector<std::pair<Relation, Kind>>{{positive, Kind::holds},
                                              {negative, Kind::holds},
                                              {nonzero, Kind::holds},
                                              {nonnegative, Kind::open},
                                              {nonpositive, Kind::open},
                                              {zero, Kind::open}}) {
    OnLine c({"0", "1"}, positive);  // x > 0 where x is of a sign
    c.sign().domain.where = {{c.sign().formula, relation}};
    EXPECT_EQ(c.finding(pieces({plain()})).kind, expected) << static_cast<int>(relation);
  }
}

TEST(Condition, a_condition_excludes_only_the_faces_on_which_it_vanishes) {
  for (const bool also_v : {false, true}) {
    Case c;
    const Term u = c.symbol("u");
    const Term v = c.symbol("v");
    // u v > 0 on the square where u != 0: false at (1, 0).
    Domain domain{{c.segment("u"), c.segment("v")}, {{u, Relation::nonzero}}};
    if (also_v) domain.where.push_back({v, Relation::nonzero});
    c.claim(Sign{c.product({u, v}), Relation::positive, domain});
    EXPECT_EQ(c.finding(pieces({plain()})).kind, also_v ? Kind::holds : Kind::open);
  }
}

TEST(Condition, a_condition_that_vanishes_at_the_corners_alone_excludes_no_more) {
  // x (1 - x) != 0 leaves the inside in; (x - 1/2)^2 is 0 there, and bisected at 1/2 it is 0 at
  // a corner where the condition is not.
  OnLine c({"1/4", "-1", "1"}, Relation::positive);
  c.sign().domain.where = {{c.product({c.x, c.difference(c.one, c.x)}), Relation::nonzero}};
  EXPECT_OPEN(c.finding(pieces({c.halved(), plain(), plain()})), "do not show");
  // x (1 - x) itself is positive there.
  OnLine d({"0", "1", "-1"}, Relation::positive);
  d.sign().domain.where = {{d.sign().formula, Relation::nonzero}};
  EXPECT_HOLDS(d.finding(pieces({plain()})));
}

TEST(Condition, each_condition_is_broken_in_its_own_way) {
  using enum Relation;
  // The condition 'constant relation 0' on [0, 1].
  const std::vector<std::tuple<std::string, Relation, bool>> cases = {
      {"-1", positive, true},    {"-1", nonnegative, true}, {"1", negative, true},
      {"1", nonpositive, true},  {"1", zero, true},         {"-1", zero, true},
      {"1", positive, false},    {"1", nonzero, false},     {"0", zero, false},
      {"0", nonnegative, false}, {"0", positive, true},     {"0", negative, true}};
  for (const auto& [constant, relation, broken] : cases) {
    OnLine c({"-1"}, positive);  // false, were there a point
    c.evidence.nodes.clear();
    c.statement.nodes.push_back({Node::Kind::constant, constant, {}, 0});
    c.sign().domain.where = {{static_cast<Term>(c.statement.nodes.size()) - 1, relation}};
    EXPECT_EQ(c.finding(pieces({outside(0)})).kind, broken ? Kind::holds : Kind::open)
        << constant << ' ' << static_cast<int>(relation);
  }
}

}  // namespace
}  // namespace seam::check::test
