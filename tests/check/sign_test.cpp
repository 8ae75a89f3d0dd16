// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "on_line.h"

namespace seam::check::test {
namespace {

// Every rule accepts what it is for.

TEST(Sign, positive_coefficients_show_a_positive_polynomial) {
  OnLine c({"1", "1"}, Relation::positive);
  EXPECT_HOLDS(c.finding(pieces({plain()})));
}

TEST(Sign, each_relation_takes_its_own_signs) {
  using enum Relation;
  for (const auto& [constant, relations] :
       std::vector<std::pair<std::string, std::vector<Relation>>>{
           {"1", {positive, nonnegative, nonzero}}, {"-1", {negative, nonpositive, nonzero}}})
    for (const Relation relation : {positive, nonnegative, nonzero, nonpositive, negative}) {
      OnLine c({constant}, relation);
      Pieces evidence = pieces({plain()});
      evidence.side = constant == "1" ? positive : negative;
      const bool holds = std::ranges::find(relations, relation) != relations.end();
      EXPECT_EQ(c.finding(evidence).kind, holds ? Kind::holds : Kind::open);
    }
}

TEST(Sign, a_zero_on_an_open_facet_does_no_harm) {
  OnLine c({"0", "1"}, Relation::positive,
           [](Case& k) { return k.segment("x", "0", "1", true, false); });
  EXPECT_HOLDS(c.finding(pieces({plain()})));
  EXPECT_HOLDS(c.finding(pieces({c.halved(), plain(), plain()})));
  EXPECT_OPEN(c.finding(c.at("0")), "outside the domain");
}

TEST(Sign, a_zero_on_the_other_facet_does_harm) {
  OnLine c({"0", "1"}, Relation::positive,
           [](Case& k) { return k.segment("x", "0", "1", false, true); });
  EXPECT_OPEN(c.finding(pieces({plain()})), "do not show the sign");
}

TEST(Sign, zeros_at_the_corners_of_an_open_triangle_do_no_harm) {
  for (const bool open : {true, false}) {
    Case c;
    const Term u = c.symbol("u");
    const Term v = c.symbol("v");
    c.claim(Sign{c.product({u, v}), Relation::positive, {{c.triangle(open)}, {}}});
    EXPECT_EQ(c.finding(pieces({plain()})).kind, open ? Kind::holds : Kind::open);
  }
}

TEST(Sign, a_zero_at_infinity_does_no_harm) {
  OnLine c({"1"}, Relation::positive, [](Case& k) { return k.ray("x", "0"); });
  EXPECT_HOLDS(c.finding(pieces({plain()})));
  OnLine d({"1", "-1", "1"}, Relation::positive, [](Case& k) { return k.ray("x", "0"); });
  // Split at 1 = 0 + the direction.
  EXPECT_HOLDS(d.finding(pieces({d.halved(), plain(), plain()})));
}

TEST(Sign, a_zero_at_one_of_two_corners_at_infinity_does_no_harm) {
  for (const bool infinite : {true, false}) {
    Case c;
    const Term one = c.number(1);
    const Term nil = c.number(0);
    // u >= 0 to infinity, v likewise or to 1; in the first case u + 1 has no term at the corner
    // at infinity of v, in the second u + 1 - v is 0 at (0, 1).
    const Simplex quarter = {
        {"u", "v"},
        {{one, nil, nil}, {nil, one, nil}, {infinite ? nil : one, nil, one}},
        {false, false, false}};
    const Term u = c.symbol("u");
    const Term formula =
        infinite ? c.sum({u, one}) : c.sum({u, one, c.scaled(-1, c.symbol("v"))});
    c.claim(Sign{formula, Relation::positive, {{quarter}, {}}});
    EXPECT_EQ(c.finding(pieces({plain()})).kind, infinite ? Kind::holds : Kind::open);
  }
}

TEST(Sign, a_corner_that_a_split_puts_on_an_open_facet_needs_no_sign) {
  for (const bool open : {true, false}) {
    Case c;
    const Term one = c.number(1);
    const Term v = c.symbol("v");
    Simplex triangle = c.triangle();
    triangle.open[2] = open;  // v = 0
    c.claim(Sign{v, Relation::positive, {{triangle}, {}}});
    const Step on_facet = split(0, {one, one, c.number(0)});
    EXPECT_EQ(c.finding(pieces({on_facet, plain(), plain()})).kind,
              open ? Kind::holds : Kind::open);
  }
}

TEST(Sign, a_corner_that_a_split_puts_inside_needs_a_sign_whatever_is_open) {
  for (const bool low : {false, true})
    for (const bool high : {false, true}) {
      OnLine c({"1/4", "-1", "1"}, Relation::positive,
               [=](Case& k) { return k.segment("x", "0", "1", low, high); });
      EXPECT_OPEN(c.finding(pieces({c.halved(), plain(), plain()})), "do not show");
    }
}

TEST(Sign, bisection_shows_what_the_whole_does_not) {
  OnLine c({"1", "-3", "3"}, Relation::positive);  // least 1/4 at 1/2
  EXPECT_OPEN(c.finding(pieces({plain()})), "do not show");
  EXPECT_HOLDS(c.finding(pieces({c.halved(), plain(), plain()})));
}

TEST(Sign, a_split_at_any_weights_covers_the_piece) {
  // Touches 0 at 1/3: weights 2, 1. And with an uneven scale.
  OnLine c({"1", "-6", "9"}, Relation::nonnegative);
  EXPECT_HOLDS(c.finding(pieces({split(0, {c.two, c.one}), plain(), plain()})));
  const Term four = c.number(4);
  EXPECT_HOLDS(c.finding(pieces({split(0, {four, c.two}), plain(), plain()})));
  EXPECT_OPEN(c.finding(pieces({split(0, {c.one, c.two}), plain(), plain()})), "do not show");
}

TEST(Sign, a_split_at_an_algebraic_point_covers_the_piece) {
  Case c;
  const Term root = c.root("sqrt(2)", c.number(2), "1", "2");
  const Term x = c.symbol("x");
  // (x - sqrt(2)/2)^2, a split at sqrt(2)/2.
  const Term half = c.product({root, c.number("1/2")});
  c.claim(
      Sign{c.power(c.difference(x, half), 2), Relation::nonnegative, {{c.segment("x")}, {}}});
  const Term rest = c.difference(c.number(1), half);
  EXPECT_HOLDS(c.finding(pieces({split(0, {rest, half}), plain(), plain()})));
  EXPECT_OPEN(c.finding(pieces({split(0, {half, rest}), plain(), plain()})), "do not show");
}

TEST(Sign, a_corner_with_weight_zero_gets_no_part) {
  OnLine c({"1"}, Relation::positive);
  const Term nil = c.number(0);
  EXPECT_HOLDS(c.finding(pieces({split(0, {c.one, nil}), plain()})));
  EXPECT_OPEN(c.finding(pieces({split(0, {c.one, nil}), plain(), plain()})), "too many");
}

TEST(Sign, a_triangle_is_split_at_an_inner_point) {
  Case c;
  const Term u = c.symbol("u");
  const Term v = c.symbol("v");
  const Term one = c.number(1);
  const Term nil = c.number(0);
  const Term w = c.difference(c.difference(one, u), v);
  // u^2 + v^2 + w^2 - 1/3: 0 at the centre alone.
  c.claim(Sign{c.sum({c.power(u, 2), c.power(v, 2), c.power(w, 2), c.number("-1/3")}),
               Relation::nonnegative,
               {{c.triangle()}, {}}});
  const Step at_centre = split(0, {one, one, one});
  EXPECT_OPEN(c.finding(pieces({at_centre, plain(), plain(), plain()})), "do not show");
  const Step a = split(0, {nil, one, one});
  const Step b = split(0, {one, nil, one});
  const Step d = split(0, {one, one, nil});
  EXPECT_HOLDS(c.finding(
      pieces({at_centre, a, plain(), plain(), b, plain(), plain(), d, plain(), plain()})));
  EXPECT_OPEN(c.finding(pieces(
                  {at_centre, b, plain(), plain(), a, plain(), plain(), d, plain(), plain()})),
              "do not show");
}

TEST(Sign, factors_are_split_each_on_their_own) {
  Case c;
  const Term u = c.symbol("u");
  const Term v = c.symbol("v");
  // (u - v)^2 + 1/4 on the square
  const Term formula = c.sum({c.power(c.difference(u, v), 2), c.number("1/4")});
  c.claim(Sign{formula, Relation::positive, {{c.segment("u"), c.segment("v")}, {}}});
  const Term one = c.number(1);
  EXPECT_OPEN(c.finding(pieces({plain()})), "do not show");
  const Step by_u = split(0, {one, one});
  const Step by_v = split(1, {one, one});
  EXPECT_HOLDS(c.finding(pieces({by_u, by_v, plain(), plain(), by_v, plain(), plain()})));
}

TEST(Sign, a_strict_sign_on_a_square_asks_for_every_corner) {
  Case c;
  const Term u = c.symbol("u");
  const Term v = c.symbol("v");
  c.claim(Sign{c.sum({u, v}), Relation::positive, {{c.segment("u"), c.segment("v")}, {}}});
  EXPECT_OPEN(c.finding(pieces({plain()})), "do not show");
  // With u > 0 the zero is gone, although u v + ... has no pure power there.
  auto& domain = std::get<Sign>(c.statement.obligations.front()).domain;
  domain.factors.front().open = {false, true};
  EXPECT_HOLDS(c.finding(pieces({plain()})));
}

TEST(Sign, an_identity_is_zero_on_every_domain) {
  OnLine c({"0"}, Relation::zero);
  EXPECT_HOLDS(c.finding(Computation{}));
  OnLine d({"0", "1"}, Relation::zero);
  EXPECT_OPEN(d.finding(Computation{}), "depends on variables");
  EXPECT_OPEN(d.finding(pieces({plain()})), "do not show");
  EXPECT_FAILS(d.finding(d.at("1/2")));
}

TEST(Sign, a_number_is_decided_by_computing) {
  using enum Relation;
  for (const auto& [relation, expected] :
       std::vector<std::pair<Relation, Kind>>{{positive, Kind::fails},
                                              {nonnegative, Kind::fails},
                                              {zero, Kind::fails},
                                              {nonzero, Kind::holds},
                                              {nonpositive, Kind::holds},
                                              {negative, Kind::holds}}) {
    Case c;
    const Term root = c.root("sqrt(5)", c.number(5), "2", "3");
    c.claim(Sign{c.sum({root, c.number("-9/4")}), relation, {}});
    EXPECT_EQ(c.finding(Computation{}).kind, expected);
  }
}

TEST(Sign, a_number_is_compared_with_a_very_near_rational) {
  Case c;
  const Term root = c.root("sqrt(2)", c.number(2), "1", "2");
  // A convergent of sqrt(2) whose error is about 10^-41.
  const Term near = c.number(
      "-228725309250740208744750893347264645481/"
      "161733217200188571081311986634082331709");
  c.claim(Sign{c.sum({root, near}), Relation::zero, {}});
  EXPECT_FAILS(c.finding(Computation{}));
}

TEST(Sign, a_number_under_a_condition_is_refuted_only_where_the_condition_holds) {
  Case c;
  const Term minus = c.number(-1);
  const Term plus = c.number(1);
  c.claim(Sign{minus, Relation::positive, {{}, {{plus, Relation::positive}}}});
  EXPECT_FAILS(c.finding(Computation{}));
  c.claim(Sign{minus, Relation::positive, {{}, {{minus, Relation::positive}}}});
  EXPECT_OPEN(c.finding(Computation{}), "breaks a condition");
  EXPECT_HOLDS(c.finding(pieces({outside(0)})));
}

TEST(Sign, a_witness_refutes) {
  OnLine c({"-1/2", "1"}, Relation::nonnegative);
  EXPECT_FAILS(c.finding(c.at("1/4")));
  EXPECT_FAILS(c.finding(c.at("0")));
  OnLine d({"-1/2", "1"}, Relation::nonzero);
  EXPECT_FAILS(d.finding(d.at("1/2")));
}

TEST(Sign, an_algebraic_witness_refutes) {
  OnLine c({"-2", "0", "1"}, Relation::nonzero,
           [](Case& k) { return k.segment("x", "0", "2"); });
  const Term root = c.root("r", c.number(2), "1", "2");
  EXPECT_FAILS(c.finding(Witness{{{"x"}, {root}}, {}}));
}

}  // namespace
}  // namespace seam::check::test
