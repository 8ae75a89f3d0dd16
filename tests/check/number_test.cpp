// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <gtest/gtest.h>

#include <tuple>

#include "builder.h"

namespace seam::check::test {
namespace {

// One claim that holds whatever the generator, if only it is accepted.
Finding with_generator(const std::vector<std::string>& coefficients, const std::string& low,
                       const std::string& high) {
  Case c;
  const Term x = c.symbol("r");
  c.generator("r", c.polynomial(x, coefficients), low, high);
  c.claim(Zero{c.number(0)});
  return c.finding(Computation{});
}

// Evidence that must be rejected.

TEST(Number, an_interval_with_two_roots_is_rejected) {
  EXPECT_OPEN(with_generator({"-2", "0", "1"}, "-2", "2"), "no change of sign");
}

TEST(Number, an_interval_with_three_roots_is_rejected) {
  EXPECT_HOLDS(with_generator({"0", "-1", "0", "1"}, "-1/2", "1/2"));  // x^3 - x
  EXPECT_OPEN(with_generator({"0", "-1", "0", "1"}, "-2", "2"), "one simple root");
}

TEST(Number, an_interval_without_a_root_is_rejected) {
  EXPECT_OPEN(with_generator({"-2", "0", "1"}, "2", "3"), "no change of sign");
}

TEST(Number, a_root_of_even_multiplicity_is_rejected) {
  EXPECT_OPEN(with_generator({"1", "-2", "1"}, "0", "2"), "no change of sign");
}

TEST(Number, a_root_of_odd_multiplicity_is_rejected) {
  EXPECT_OPEN(with_generator({"-1", "3", "-3", "1"}, "0", "2"), "one simple root");
}

TEST(Number, a_root_at_an_end_is_rejected) {
  EXPECT_OPEN(with_generator({"-2", "1"}, "2", "3"), "no change of sign");
  EXPECT_OPEN(with_generator({"-2", "1"}, "1", "2"), "no change of sign");
}

TEST(Number, an_empty_interval_is_rejected) {
  EXPECT_OPEN(with_generator({"-2", "0", "1"}, "2", "1"), "empty");
  EXPECT_OPEN(with_generator({"-2", "1"}, "2", "2"), "empty");
}

TEST(Number, a_constant_defines_nothing) {
  EXPECT_OPEN(with_generator({"0"}, "0", "1"), "no change of sign");
  EXPECT_OPEN(with_generator({"1"}, "0", "1"), "no change of sign");
}

TEST(Number, a_definition_by_a_variable_is_rejected) {
  Case c;
  c.root("r", c.symbol("x"), "1", "2");
  c.claim(Zero{c.number(0)});
  EXPECT_OPEN(c.finding(Computation{}), "later");
}

TEST(Number, a_definition_by_a_later_number_is_rejected) {
  Case c;
  c.root("a", c.symbol("b"), "1", "2");
  c.root("b", c.number(2), "1", "2");
  c.claim(Zero{c.number(0)});
  EXPECT_OPEN(c.finding(Computation{}), "later");
}

TEST(Number, two_numbers_of_one_name_are_rejected) {
  Case c;
  c.root("r", c.number(2), "1", "2");
  c.claim(Zero{c.number(0)});
  c.evidence_begins();
  c.root("r", c.number(3), "1", "2");
  EXPECT_OPEN(c.finding(Computation{}), "two numbers have one name");
}

TEST(Number, evidence_cannot_turn_a_variable_into_a_number) {
  Case c;
  const Term x = c.symbol("x");
  c.claim(Zero{c.difference(c.power(x, 2), c.number(2))});  // false of the variable x
  c.evidence_begins();
  c.root("x", c.number(2), "1", "2");
  EXPECT_OPEN(c.finding(Computation{}), "the name of a variable");
}

TEST(Number, a_number_is_no_variable_of_a_domain) {
  Case c;
  c.root("x", c.number(2), "1", "2");
  c.claim(Sign{c.number(1), Relation::positive, {{c.segment("x")}, {}}});
  EXPECT_OPEN(c.finding(Computation{}), "the name of a variable");
}

TEST(Number, a_number_is_no_unknown) {
  for (const bool for_all : {true, false}) {
    Case c;
    c.root("x", c.number(2), "1", "2");
    c.claim(Solutions{{}, for_all ? "y" : "x", {for_all ? "x" : "y"}, c.segment("y"), {}});
    EXPECT_OPEN(c.finding(Roots{}), "the name of a variable");
  }
}

TEST(Number, a_witness_cannot_give_a_value_to_a_number) {
  Case c;
  const Term root = c.root("r", c.number(2), "1", "2");
  c.claim(Zero{c.difference(c.power(root, 2), c.number(2))});
  EXPECT_OPEN(c.finding(Witness{{{"r"}, {c.number(1)}}, {}}), "unknown variable");
}

TEST(Number, a_difference_of_equal_numbers_in_a_reducible_tower_stays_open) {
  Case c;
  const Term a = c.root("sqrt(5)", c.number(5), "2", "3");
  const Term b = c.root("sqrt(20)", c.number(20), "4", "5");
  const Term nothing = c.difference(b, c.scaled(2, a));
  c.claim(Zero{nothing});
  EXPECT_OPEN(c.finding(Computation{}), "normal form");
  EXPECT_OPEN(c.finding(Witness{}), "could not be decided");
  for (const Relation relation :
       {Relation::positive, Relation::nonnegative, Relation::zero, Relation::nonzero,
        Relation::nonpositive, Relation::negative}) {
    c.claim(Sign{nothing, relation, {}});
    EXPECT_OPEN(c.finding(Computation{}), "could not be decided");
    EXPECT_OPEN(c.finding(pieces({plain()})), "");
  }
  c.claim(Distinct{{{a, nothing}, {a, c.number(0)}}});
  EXPECT_OPEN(c.finding(Computation{}), "not seen to be different");
}

TEST(Number, a_hidden_zero_does_not_hide_a_difference) {
  Case c;
  const Term a = c.root("sqrt(5)", c.number(5), "2", "3");
  const Term b = c.root("sqrt(20)", c.number(20), "4", "5");
  const Term x = c.symbol("x");
  const Term hidden = c.product({c.difference(b, c.scaled(2, a)), x});
  c.claim(Zero{c.sum({hidden, c.power(x, 3)})});
  EXPECT_FAILS(c.finding(Computation{}));
  c.claim(Distinct{{{hidden, a}, {c.number(0), b}}});
  EXPECT_OPEN(c.finding(Computation{}), "variable");
}

// Every rule accepts what it is for.

TEST(Number, the_other_root_is_another_number) {
  for (const auto& [low, high, expected] :
       {std::tuple{"1", "2", Kind::holds}, std::tuple{"-2", "-1", Kind::fails}}) {
    Case c;
    const Term r = c.root("r", c.number(2), low, high);
    c.claim(Sign{r, Relation::positive, {}});
    EXPECT_EQ(c.finding(Computation{}).kind, expected);
  }
}

TEST(Number, a_root_is_isolated_in_a_wide_interval_with_turning_points) {
  // x^3 - 3x + 3 has one real root, near -2.1, and turns at 1 and -1.
  EXPECT_HOLDS(with_generator({"3", "-3", "0", "1"}, "-1000", "1000"));
}

TEST(Number, near_roots_are_told_apart) {
  // (x - 1)(x - 1 - 10^-30) between the two, and beyond the second
  const std::vector<std::string> two = {
      "1000000000000000000000000000001/1000000000000000000000000000000",
      "-2000000000000000000000000000001/1000000000000000000000000000000", "1"};
  EXPECT_HOLDS(with_generator(
      two, "2000000000000000000000000000001/2000000000000000000000000000000", "2"));
  EXPECT_OPEN(with_generator(two, "0", "2"), "no change of sign");
}

TEST(Number, a_rational_root_may_lie_at_the_middle) {
  Case c;
  const Term r = c.symbol("r");
  c.generator("r", c.polynomial(r, {"-1", "2"}), "0", "1");
  c.claim(Zero{c.sum({r, c.number("-1/2")})});
  EXPECT_HOLDS(c.finding(Computation{}));
}

TEST(Number, nested_radicals_have_normal_forms_and_signs) {
  Case c;
  const Term a = c.root("a", c.number(5), "2", "3");
  const Term b = c.root("b", c.sum({a, c.number(-2)}), "0", "1");  // sqrt(sqrt(5) - 2)
  const Term fourth = c.power(b, 4);                               // 9 - 4 sqrt(5)
  c.claim(Zero{c.sum({fourth, c.scaled(4, a), c.number(-9)})});
  EXPECT_HOLDS(c.finding(Computation{}));
  c.claim(
      Sign{c.sum({b, c.number("-12147/25000")}), Relation::positive, {}});  // b = 0.485868...
  EXPECT_FAILS(c.finding(Computation{}));
}

TEST(Number, a_defining_polynomial_need_not_be_monic) {
  Case c;
  const Term g = c.symbol("g");
  c.generator("g", c.polynomial(g, {"-1", "-1", "0", "3"}), "4/5", "6/5");
  c.claim(Zero{c.sum(
      {c.scaled(3, c.power(g, 5)), c.scaled(-1, c.power(g, 3)), c.scaled(-1, c.power(g, 2))})});
  EXPECT_HOLDS(c.finding(Computation{}));
}

TEST(Number, a_negative_leading_coefficient_keeps_signs) {
  Case c;
  const Term g = c.symbol("g");
  c.generator("g", c.polynomial(g, {"2/3", "0", "-1/3"}), "1", "2");
  c.claim(Zero{c.sum({c.power(g, 2), c.number(-2)})});
  EXPECT_HOLDS(c.finding(Computation{}));
  c.claim(Sign{g, Relation::positive, {}});
  EXPECT_HOLDS(c.finding(Computation{}));
}

TEST(Number, a_leading_coefficient_may_be_irrational) {
  Case c;
  const Term a = c.root("a", c.number(2), "1", "2");
  const Term q = c.symbol("q");  // 1/sqrt(2)
  c.generator("q", c.sum({c.product({a, q}), c.number(-1)}), "1/2", "1");
  c.claim(Sign{c.sum({q, c.number("-70711/100000")}), Relation::negative, {}});
  EXPECT_HOLDS(c.finding(Computation{}));
  // Its normal form does not know that a q = 1.
  c.claim(Zero{c.sum({c.product({a, q}), c.number(-1)})});
  EXPECT_OPEN(c.finding(Computation{}), "normal form");
}

TEST(Number, many_numbers_make_a_tower) {
  Case c;
  Term sum = c.number(2);
  for (int i = 0; i < 20; ++i)  // sqrt(2 + sqrt(2 + ...)) rises to 2
    sum = c.sum({c.number(2), c.root("r" + std::to_string(i), sum, "1", "3")});
  c.claim(Sign{c.sum({sum, c.number(-4)}), Relation::negative, {}});
  EXPECT_HOLDS(c.finding(Computation{}));
}

}  // namespace
}  // namespace seam::check::test
