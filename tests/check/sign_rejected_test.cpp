// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <gtest/gtest.h>

#include "on_line.h"

namespace seam::check::test {
namespace {

// Evidence that must be rejected.

TEST(Sign, a_zero_at_a_corner_is_not_positive) {
  OnLine c({"0", "1"}, Relation::positive);
  EXPECT_OPEN(c.finding(pieces({plain()})), "do not show the sign");
}

TEST(Sign, a_zero_on_an_edge_of_a_triangle_is_not_positive) {
  Case c;
  const Term u = c.symbol("u");
  const Term v = c.symbol("v");
  const Term w = c.sum({c.number(1), c.scaled(-1, u), c.scaled(-1, v)});
  // Positive at the corners 0 and 2, and inside, but 0 at corner 1.
  const Term formula = c.sum({w, v, c.product({u, v})});
  c.claim(Sign{formula, Relation::positive, {{c.triangle()}, {}}});
  EXPECT_OPEN(c.finding(pieces({plain()})), "do not show the sign");
}

TEST(Sign, a_zero_inside_is_not_positive_although_both_ends_are) {
  OnLine c({"1", "-4", "4"}, Relation::positive);
  EXPECT_OPEN(c.finding(pieces({plain()})), "do not show the sign");
  EXPECT_OPEN(c.finding(pieces({c.halved(), plain(), plain()})), "do not show the sign");
}

TEST(Sign, a_missing_piece_is_rejected) {
  OnLine c({"1", "-1", "1"}, Relation::positive);
  EXPECT_OPEN(c.finding(pieces({c.halved(), plain()})), "lacks a piece");
  EXPECT_OPEN(c.finding(pieces({})), "lacks a piece");
}

TEST(Sign, a_piece_too_many_is_rejected) {
  OnLine c({"1", "-1", "1"}, Relation::positive);
  EXPECT_OPEN(c.finding(pieces({c.halved(), plain(), plain(), plain()})), "steps too many");
}

TEST(Sign, a_negative_weight_is_rejected) {
  OnLine c({"1"}, Relation::positive);
  const Term minus = c.number(-1);
  EXPECT_OPEN(c.finding(pieces({split(0, {c.two, minus}), plain()})), "negative weight");
}

TEST(Sign, a_negative_algebraic_weight_is_rejected) {
  Case c;
  const Term root = c.root("sqrt(5)", c.number(5), "2", "3");
  const Term weight = c.sum({root, c.number("-9/4")});  // -0.0139...
  c.claim(Sign{c.number(1), Relation::positive, {{c.segment("x")}, {}}});
  EXPECT_OPEN(c.finding(pieces({split(0, {c.number(1), weight}), plain()})), "negative weight");
}

TEST(Sign, weights_that_are_all_zero_are_rejected) {
  OnLine c({"1"}, Relation::positive);
  const Term nil = c.number(0);
  EXPECT_OPEN(c.finding(pieces({split(0, {nil, nil})})), "all 0");
}

TEST(Sign, a_number_of_weights_other_than_that_of_corners_is_rejected) {
  OnLine c({"1"}, Relation::positive);
  EXPECT_OPEN(c.finding(pieces({split(0, {c.one}), plain()})), "one weight for each");
  EXPECT_OPEN(c.finding(pieces({split(1, {c.one, c.one}), plain(), plain()})), "none");
}

TEST(Sign, a_weight_with_a_variable_is_rejected) {
  OnLine c({"1"}, Relation::positive);
  EXPECT_OPEN(c.finding(pieces({split(0, {c.one, c.x}), plain(), plain()})), "variable");
}

TEST(Sign, evidence_for_nonzero_must_name_a_strict_side) {
  OnLine c({"0", "1"}, Relation::nonzero);
  for (const Relation side : {Relation::nonnegative, Relation::nonzero, Relation::zero}) {
    Pieces evidence = pieces({plain()});
    evidence.side = side;
    EXPECT_OPEN(c.finding(evidence), "strict");
  }
}

TEST(Sign, the_side_of_evidence_does_not_replace_the_relation) {
  OnLine c({"1"}, Relation::negative);
  Pieces evidence = pieces({plain()});
  evidence.side = Relation::positive;
  EXPECT_OPEN(c.finding(evidence), "do not show the sign");
}

TEST(Sign, a_tampered_cofactor_is_rejected) {
  OnLine c({"1/4", "-1", "1"}, Relation::nonnegative);  // (x - 1/2)^2
  Pieces evidence = pieces({plain()});
  evidence.square = c.sum({c.x, c.number("-1/2")});
  evidence.cofactor = c.one;
  EXPECT_HOLDS(c.finding(evidence));
  evidence.cofactor = c.number("4/3");
  EXPECT_OPEN(c.finding(evidence), "square times the cofactor");
}

TEST(Sign, a_square_shows_no_strict_sign) {
  for (const Relation relation : {Relation::positive, Relation::nonzero}) {
    OnLine c({"1/4", "-1", "1"}, relation);
    Pieces evidence = pieces({plain()});
    evidence.square = c.sum({c.x, c.number("-1/2")});
    evidence.cofactor = c.one;
    EXPECT_OPEN(c.finding(evidence), "strict");
  }
}

TEST(Sign, a_cofactor_of_the_wrong_sign_is_rejected) {
  OnLine c({"-1/4", "1", "-1"}, Relation::nonnegative);
  Pieces evidence = pieces({plain()});
  evidence.square = c.sum({c.x, c.number("-1/2")});
  evidence.cofactor = c.number(-1);
  EXPECT_OPEN(c.finding(evidence), "do not show the sign");
}

TEST(Sign, a_witness_outside_the_domain_is_rejected) {
  OnLine c({"0", "1"}, Relation::nonnegative);
  EXPECT_OPEN(c.finding(c.at("-1")), "outside the domain");
}

TEST(Sign, a_witness_on_an_open_facet_is_rejected) {
  for (const bool low : {false, true}) {
    OnLine c({"0", "1", "-1"}, Relation::positive,
             [low](Case& k) { return k.segment("x", "0", "1", low, !low); });
    EXPECT_OPEN(c.finding(c.at(low ? "0" : "1")), "outside the domain");
    EXPECT_FAILS(c.finding(c.at(low ? "1" : "0")));
  }
}

TEST(Sign, a_witness_where_the_relation_holds_is_rejected) {
  OnLine c({"0", "1"}, Relation::positive);
  EXPECT_OPEN(c.finding(c.at("1/2")), "holds at the witness");
}

TEST(Sign, a_witness_that_breaks_a_condition_is_rejected) {
  OnLine c({"-1/2", "1"}, Relation::nonnegative);
  c.sign().domain.where = {{c.sign().formula, Relation::positive}};
  EXPECT_OPEN(c.finding(c.at("1/4")), "breaks a condition");
}

TEST(Sign, a_witness_without_a_value_is_rejected) {
  OnLine c({"0", "1"}, Relation::positive);
  EXPECT_OPEN(c.finding(Witness{}), "lacks a value");
}

TEST(Sign, a_change_of_sign_across_a_constrained_domain_refutes_nothing) {
  OnLine c({"-1/2", "1"}, Relation::nonzero);
  Witness witness = c.at("0");
  witness.other = {c.at("1").point};
  EXPECT_FAILS(c.finding(witness));
  // x != 1/2 is all that is left out.
  c.sign().domain.where = {{c.sign().formula, Relation::nonzero}};
  EXPECT_OPEN(c.finding(witness), "holds at the witness");
}

TEST(Sign, two_points_of_one_sign_refute_nothing) {
  OnLine c({"1", "1"}, Relation::nonzero);
  Witness witness = c.at("0");
  witness.other = {c.at("1").point};
  EXPECT_OPEN(c.finding(witness), "holds at the witness");
}

TEST(Sign, a_change_of_sign_outside_the_domain_refutes_nothing) {
  OnLine c({"0", "1"}, Relation::nonzero,
           [](Case& k) { return k.segment("x", "0", "1", true, false); });
  Witness witness = c.at("1");
  witness.other = {c.at("-1").point};
  EXPECT_OPEN(c.finding(witness), "outside the domain");
}

TEST(Sign, a_domain_with_dependent_corners_is_no_domain) {
  OnLine c({"1"}, Relation::positive, [](Case& k) { return k.segment("x", "1", "1"); });
  EXPECT_OPEN(c.finding(pieces({plain()})), "dependent");
}

TEST(Sign, a_corner_of_negative_weight_makes_no_domain) {
  OnLine c({"1"}, Relation::positive, [](Case& k) {
    return Simplex{
        {"x"}, {{k.number(-1), k.number(0)}, {k.number(1), k.number(1)}}, {false, false}};
  });
  EXPECT_OPEN(c.finding(pieces({plain()})), "negative weight");
}

TEST(Sign, a_variable_without_bounds_is_nothing_for_pieces) {
  Case c;
  const Term formula = c.power(c.symbol("y"), 2);
  c.claim(Sign{formula, Relation::nonnegative, {{c.segment("x")}, {}}});
  EXPECT_OPEN(c.finding(pieces({plain()})), "a variable that has no bounds");
  EXPECT_OPEN(c.finding(Computation{}), "depends on variables");
}

TEST(Sign, a_variable_of_two_factors_is_rejected) {
  Case c;
  c.claim(Sign{c.number(1), Relation::positive, {{c.segment("x"), c.segment("x")}, {}}});
  EXPECT_OPEN(c.finding(pieces({plain()})), "twice");
}

TEST(Sign, a_corner_at_infinity_does_not_hide_a_zero) {
  // x - 1 on [0, oo): the corner at infinity alone is positive.
  OnLine c({"-1", "1"}, Relation::positive, [](Case& k) { return k.ray("x", "0"); });
  EXPECT_OPEN(c.finding(pieces({plain()})), "do not show the sign");
  EXPECT_FAILS(c.finding(c.at("1")));
}

TEST(Sign, a_positive_value_at_infinity_alone_shows_nothing) {
  // x on [0, oo)
  OnLine c({"0", "1"}, Relation::positive, [](Case& k) { return k.ray("x", "0"); });
  EXPECT_OPEN(c.finding(pieces({plain()})), "do not show the sign");
}

TEST(Sign, of_a_statement_on_a_domain_computing_shows_nothing) {
  OnLine c({"1", "1"}, Relation::positive);
  EXPECT_OPEN(c.finding(Computation{}), "depends on variables");
}

TEST(Sign, a_false_number_on_a_domain_that_may_be_empty_is_not_refuted_by_computing) {
  OnLine c({"-1"}, Relation::positive);
  EXPECT_OPEN(c.finding(Computation{}), "lacks a value");
}

}  // namespace
}  // namespace seam::check::test
