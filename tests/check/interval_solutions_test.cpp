// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "builder.h"

namespace seam::check::test {
namespace {

// x^3 - 3x + 1 on [0, 2]: one root within [1/3, 1/2], one within [3/2, 8/5].
struct Intervals : Case {
  Term x, formula;
  Roots roots;

  explicit Intervals(std::vector<Solution> intervals = {{-1, "1/3", "1/2"}, {-1, "3/2", "8/5"}},
                     bool ray_only = false) {
    x = symbol("x");
    formula = polynomial(x, {"1", "-3", "0", "1"});
    claim(Solutions{{formula},
                    "x",
                    {},
                    ray_only ? ray("x", "0") : segment("x", "0", "2"),
                    std::move(intervals)});
    evidence_begins();
    const Term one = number(1);
    roots.divisor = formula;
    roots.cofactors = roots.quotients = {one};
    roots.inside = {nonzero(Relation::negative), nonzero(Relation::positive)};
    const Step halved = split(0, {one, one});
    roots.outside = {nonzero(Relation::positive),
                     nonzero(Relation::negative, {halved, plain(), plain()}),
                     nonzero(Relation::positive)};
  }
  Solutions& stated() { return std::get<Solutions>(statement.obligations.front()); }
};

TEST(IntervalSolutions, intervals_are_proven) {
  Intervals c;
  EXPECT_HOLDS(c.finding(c.roots));
}

TEST(IntervalSolutions, intervals_on_a_ray_are_proven) {
  Intervals c({{-1, "1/3", "1/2"}, {-1, "3/2", "8/5"}}, true);
  EXPECT_HOLDS(c.finding(c.roots));
}

TEST(IntervalSolutions, intervals_in_a_domain_given_from_right_to_left_are_proven) {
  Intervals c;
  std::swap(c.stated().domain.corners[0], c.stated().domain.corners[1]);
  EXPECT_HOLDS(c.finding(c.roots));
}

TEST(IntervalSolutions, overlapping_intervals_are_rejected) {
  Intervals c({{-1, "1/3", "1/2"}, {-1, "1/3", "1/2"}});
  EXPECT_OPEN(c.finding(c.roots), "overlap");
  Intervals d({{-1, "3/2", "8/5"}, {-1, "1/3", "1/2"}});
  std::swap(d.roots.inside[0], d.roots.inside[1]);
  d.roots.outside[0] =
      nonzero(Relation::positive, {split(0, {d.number(1), d.number(1)}), plain(), plain()});
  EXPECT_OPEN(d.finding(d.roots), "");
}

TEST(IntervalSolutions, touching_intervals_have_one_point_between_them) {
  Intervals c({{-1, "1/3", "1"}, {-1, "1", "8/5"}});
  // The derivative is 0 at 1.
  EXPECT_OPEN(c.finding(c.roots), "do not show");
  Case d;
  const Term x = d.symbol("x");
  d.claim(Solutions{{d.polynomial(x, {"0", "-1", "0", "1"})},  // x^3 - x
                    "x",
                    {},
                    d.segment("x", "-1/2", "2"),
                    {{-1, "-1/2", "1/2"}, {-1, "3/4", "2"}}});
  Roots roots;
  roots.divisor = std::get<Solutions>(d.statement.obligations.front()).system.front();
  roots.cofactors = roots.quotients = {d.number(1)};
  roots.inside = {nonzero(Relation::negative), nonzero(Relation::positive)};
  roots.outside = {nonzero(Relation::positive), nonzero(Relation::negative),
                   nonzero(Relation::positive)};
  EXPECT_HOLDS(d.finding(roots));
}

TEST(IntervalSolutions, an_interval_with_two_roots_is_rejected) {
  Intervals c({{-1, "1/3", "8/5"}});
  c.roots.inside.pop_back();
  c.roots.outside.pop_back();
  EXPECT_OPEN(c.finding(c.roots), "no change of sign");
}

TEST(IntervalSolutions, an_interval_without_a_root_is_rejected) {
  Intervals c({{-1, "1/3", "1/2"}, {-1, "17/10", "19/10"}});
  EXPECT_OPEN(c.finding(c.roots), "");
}

TEST(IntervalSolutions, a_root_beside_the_intervals_is_not_overlooked) {
  Intervals c({{-1, "1/3", "1/2"}});
  c.roots.inside.pop_back();
  c.roots.outside.pop_back();
  EXPECT_OPEN(c.finding(c.roots), "do not show");
}

TEST(IntervalSolutions, an_interval_that_leaves_the_domain_is_rejected) {
  Intervals c({{-1, "1/3", "1/2"}, {-1, "3/2", "3"}});
  EXPECT_OPEN(c.finding(c.roots), "leaves the domain");
}

TEST(IntervalSolutions, a_tree_too_few_is_rejected) {
  Intervals c;
  Roots forged = c.roots;
  forged.outside.pop_back();
  EXPECT_OPEN(c.finding(forged), "one tree for each");
  forged = c.roots;
  forged.inside.pop_back();
  EXPECT_OPEN(c.finding(forged), "one tree for each");
}

TEST(IntervalSolutions, exact_ones_beside_intervals_are_rejected) {
  Intervals c;
  c.stated().solutions.front() = {c.x, {}, {}};
  EXPECT_OPEN(c.finding(c.roots), "unsupported");
}

TEST(IntervalSolutions, a_root_outside_of_all_intervals_refutes) {
  Case c;
  const Term x = c.symbol("x");
  c.claim(Solutions{{c.polynomial(x, {"-2", "0", "1"})},
                    "x",
                    {},
                    c.segment("x", "0", "2"),
                    {{-1, "3/2", "2"}}});
  const Term root = c.root("r", c.number(2), "1", "2");
  EXPECT_FAILS(c.finding(WrongSolution{root, -1}));
  EXPECT_OPEN(c.finding(WrongSolution{c.number("7/4"), -1}), "wrong or missing");
  EXPECT_OPEN(c.finding(WrongSolution{root, 0}), "interval is not refuted");
  std::get<Solutions>(c.statement.obligations.front()).solutions = {{-1, "4/3", "2"}};
  EXPECT_OPEN(c.finding(WrongSolution{root, -1}), "wrong or missing");
}

TEST(IntervalSolutions, intervals_among_all_numbers_reach_to_infinity_on_both_sides) {
  for (const bool complete : {true, false}) {
    Case c;
    const Term x = c.symbol("x");
    const Term formula = c.polynomial(x, {"-2", "0", "1"});
    std::vector<Solution> intervals = {{-1, "1", "2"}};
    if (complete) intervals.insert(intervals.begin(), {-1, "-2", "-1"});
    c.claim(Solutions{{formula}, "x", {}, {{"x"}, {}, {}}, intervals});
    Roots roots;
    roots.divisor = formula;
    roots.cofactors = roots.quotients = {c.number(1)};
    roots.inside = {nonzero(Relation::positive)};
    roots.outside = {nonzero(Relation::negative), nonzero(Relation::positive)};
    if (complete) {
      roots.inside.insert(roots.inside.begin(), nonzero(Relation::negative));
      roots.outside.insert(roots.outside.begin(), nonzero(Relation::positive));
    }
    EXPECT_EQ(c.finding(roots).kind, complete ? Kind::holds : Kind::open);
  }
}

TEST(IntervalSolutions, a_root_at_an_open_end_is_none) {
  for (const bool at_low : {true, false})
    for (const bool open : {true, false}) {
      Case c;
      const Term x = c.symbol("x");
      // x (x - 2/3), or mirrored: a root at the end 0, one inside
      const Term formula = c.product({x, c.polynomial(x, {at_low ? "-2/3" : "2/3", "1"})});
      c.claim(Solutions{
          {formula},
          "x",
          {},
          at_low ? c.segment("x", "0", "1", open) : c.segment("x", "-1", "0", false, open),
          {at_low ? Solution{-1, "1/2", "3/4"} : Solution{-1, "-3/4", "-1/2"}}});
      Roots roots;
      roots.divisor = formula;
      roots.cofactors = roots.quotients = {c.number(1)};
      roots.inside = {nonzero(at_low ? Relation::positive : Relation::negative)};
      roots.outside = {nonzero(Relation::negative), nonzero(Relation::positive)};
      if (!at_low) std::swap(roots.outside[0], roots.outside[1]);
      EXPECT_EQ(c.finding(roots).kind, open ? Kind::holds : Kind::open);
    }
}

}  // namespace
}  // namespace seam::check::test
