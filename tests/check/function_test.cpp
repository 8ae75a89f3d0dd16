// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "builder.h"

namespace seam::check::test {
namespace {

using enum Relation;
using enum Reduction::Kind;

/// Statements about r = sqrt(1 - c^2) for c in [0, 1].
struct OnCircle : Case {
  Term one = number(1);
  Term c = symbol("c"), r = symbol("r");
  Term square = difference(one, power(c, 2));
  OnCircle() { statement.functions = {{"r", square, 2}}; }

  void claim_sign(Term formula, Relation relation, std::vector<Constraint> where = {}) {
    claim(Sign{formula, relation, {{segment("c")}, std::move(where)}});
    evidence_begins();
  }
  Witness at(const std::string& c_value, const std::string& r_value) {
    return {{{"c", "r"}, {number(c_value), number(r_value)}}, {}};
  }
};

TEST(Functions, an_identity_of_functions_is_seen_in_normal_form) {
  OnCircle k;
  k.claim(Zero{k.difference(k.power(k.r, 4), k.power(k.square, 2))});
  EXPECT_HOLDS(k.finding(Computation{}));
}

TEST(Functions, an_identity_of_functions_that_fails_takes_a_point_with_their_values) {
  OnCircle k;
  k.claim(Zero{k.difference(k.r, k.square)});
  EXPECT_OPEN(k.finding(Computation{}), "the normal form is not 0");
  EXPECT_FAILS(k.finding(k.at("3/5", "4/5")));
  EXPECT_OPEN(k.finding(k.at("3/5", "-4/5")), "is not the root");
  EXPECT_OPEN(k.finding(k.at("3/5", "3/5")), "is not the root");
  EXPECT_OPEN(k.finding(k.at("0", "1")), "is 0 at the witness");
  EXPECT_OPEN(k.finding(Witness{{{"c"}, {k.number("3/5")}}, {}}), "lacks a value for a func");
}

TEST(Functions, where_a_function_has_no_value_nothing_is_claimed) {
  OnCircle k;
  k.claim(Zero{k.difference(k.power(k.r, 2), k.power(k.r, 4))});  // (1 - c^2) c^2
  EXPECT_FAILS(k.finding(k.at("3/5", "4/5")));
  EXPECT_OPEN(k.finding(k.at("2", "1")), "is not the root");
  EXPECT_OPEN(k.finding(Witness{{{"c"}, {k.number(2)}}, {}}), "lacks a value for a function");
}

TEST(Functions, a_function_that_cancels_still_stands_in_the_claim) {
  for (const bool with_function : {true, false}) {
    Case k;  // x + 1 > 0 for x in [-2, 1], where sqrt(x) has a value
    const Term x = k.symbol("x"), r = k.symbol("r");
    k.statement.functions = {{"r", x, 2}};
    const Term square = with_function ? k.power(r, 2) : x;
    k.claim(Sign{k.sum({square, k.number(1)}), positive, {{k.segment("x", "-2")}, {}}});
    k.evidence_begins();
    const Witness witness{{{"x"}, {k.number(-2)}}, {}};
    const Term weight = k.number(1);
    const Subdivision steps = {split(0, {weight, weight}), plain(), outside(0)};
    if (with_function) {
      EXPECT_OPEN(k.finding(witness), "lacks a value for a function");
      EXPECT_HOLDS(k.finding(pieces(steps)));
    } else {
      EXPECT_FAILS(k.finding(witness));
      EXPECT_OPEN(k.finding(pieces(steps)), "a condition that is none");
    }
  }
}

TEST(Functions, a_sign_fails_at_a_point_of_the_domain_with_the_values_of_functions) {
  OnCircle k;
  k.claim_sign(k.difference(k.r, k.c), nonnegative);
  EXPECT_FAILS(k.finding(k.at("4/5", "3/5")));
  EXPECT_OPEN(k.finding(k.at("3/5", "4/5")), "the relation holds");
  EXPECT_OPEN(k.finding(k.at("4/5", "-3/5")), "is not the root");
  EXPECT_OPEN(k.finding(k.at("-4/5", "3/5")), "outside the domain");
}

TEST(Functions, a_change_of_sign_does_not_refute_where_functions_are) {
  OnCircle k;
  k.claim_sign(k.difference(k.r, k.c), nonzero);
  Witness witness = k.at("4/5", "3/5");
  witness.other = {k.at("3/5", "4/5").point};
  EXPECT_OPEN(k.finding(witness), "the relation holds");
}

TEST(Functions, a_function_is_not_negative_and_positive_where_its_radicand_is) {
  OnCircle k;
  k.claim_sign(k.r, nonnegative);
  EXPECT_HOLDS(k.finding(pieces({plain()})));
  OnCircle closed;
  closed.claim_sign(closed.r, positive);  // 0 at c = 1
  EXPECT_OPEN(closed.finding(pieces({plain()})), "do not show the sign");
  EXPECT_FAILS(closed.finding(closed.at("1", "0")));
  OnCircle open;
  open.claim(Sign{open.r, positive, {{open.segment("c", "0", "1", false, true)}, {}}});
  EXPECT_HOLDS(open.finding(pieces({plain()})));
}

TEST(Functions, the_ray_of_a_function_is_cut_at_a_bound_of_its_root) {
  for (const int bound : {2, 1}) {
    OnCircle k;  // 3 - r > 0, for r <= 2
    k.claim_sign(k.difference(k.number(3), k.r), positive);
    // The point (1, bound) between (1, 0) and (0, 1): then r in [bound, oo), and r in [0,
    // bound].
    const Step cut = split(1, {k.number(1), k.number(bound)});
    const Finding found = k.finding(pieces({cut, outside(0), plain()}));
    if (bound == 2)
      EXPECT_HOLDS(found);
    else
      EXPECT_OPEN(found, "");
    EXPECT_OPEN(k.finding(pieces({cut, plain(), plain()})), "do not show the sign");
  }
}

TEST(Functions, a_radicand_may_hold_earlier_functions) {
  OnCircle k;
  const Term s = k.symbol("s");
  k.statement.functions.push_back({"s", k.sum({k.one, k.r}), 2});
  const Term f = k.product({k.difference(k.power(s, 2), k.one), k.r});
  k.claim(Zero{k.difference(f, k.square)});  // (s^2 - 1) r = r^2
  EXPECT_HOLDS(k.finding(Computation{}));
  k.claim(Zero{k.difference(f, k.one)});
  Witness witness{{{"c", "s", "r"}, {}}, {}};
  for (const auto& [root, square] : {std::pair("4/5", "9/5"), std::pair("3/5", "9/5")}) {
    k.evidence.generators.clear();
    k.evidence_begins();
    const Term value = k.root("root", k.number(square), "0", "2");
    witness.point.values = {k.number("3/5"), value, k.number(root)};
    if (std::string(root) == "4/5")
      EXPECT_FAILS(k.finding(witness));
    else
      EXPECT_OPEN(k.finding(witness), "is not the root");
  }
}

TEST(Functions, a_root_of_odd_degree_is_not_negative_either) {
  Case k;
  const Term x = k.symbol("x"), r = k.symbol("r");
  k.statement.functions = {{"r", x, 3}};
  k.claim(Sign{r, nonnegative, {{k.segment("x", "-1")}, {}}});
  k.evidence_begins();
  EXPECT_HOLDS(k.finding(pieces({plain()})));
  EXPECT_OPEN(k.finding(Witness{{{"x", "r"}, {k.number(-1), k.number(-1)}}, {}}),
              "is not the root");
}

// What a statement must not be.

TEST(Functions, a_radicand_does_not_hold_its_own_function_or_a_later_one) {
  for (const int first : {0, 1}) {
    OnCircle k;
    const Term s = k.symbol("s");
    k.statement.functions.push_back({"s", first == 0 ? k.r : s, 2});
    k.claim_sign(k.r, nonnegative);
    if (first == 0)
      EXPECT_HOLDS(k.finding(pieces({plain()})));
    else
      EXPECT_OPEN(k.finding(pieces({plain()})), "holds its own function or a later one");
    std::swap(k.statement.functions[0], k.statement.functions[1]);
    EXPECT_OPEN(k.finding(pieces({plain()})), "holds its own function or a later one");
  }
}

TEST(Functions, a_function_has_a_name_of_its_own) {
  for (const char* name : {"c", "r", "w"}) {
    OnCircle k;
    k.generator("w", k.difference(k.power(k.symbol("w"), 2), k.number(2)), "1", "2");
    k.statement.functions.push_back({name, k.square, 2});
    k.claim_sign(k.r, nonnegative);
    EXPECT_OPEN(k.finding(pieces({plain()})), "the name of something else");
  }
}

TEST(Functions, evidence_does_not_turn_a_function_into_a_number) {
  OnCircle k;
  k.claim_sign(k.difference(k.r, k.c), nonnegative);
  k.generator("r", k.difference(k.power(k.r, 2), k.number(2)), "1", "2");
  EXPECT_OPEN(k.finding(pieces({plain()})), "degenerate");
}

TEST(Functions, a_number_is_not_defined_by_a_function) {
  OnCircle k;
  k.generator("w", k.sum({k.power(k.symbol("w"), 2), k.r, k.number(-2)}), "0", "2");
  k.claim_sign(k.r, nonnegative);
  EXPECT_OPEN(k.finding(pieces({plain()})), "defined by a later one");
}

TEST(Functions, a_radicand_may_hold_a_variable_that_ranges_over_all_reals) {
  OnCircle k;
  k.statement.functions[0].operand = k.sum({k.square, k.symbol("x")});
  k.claim_sign(k.r, nonnegative);
  EXPECT_HOLDS(k.finding(pieces({plain()})));
}

TEST(Functions, a_system_of_equations_holds_none) {
  OnCircle k;
  k.claim(Solutions{{k.r}, "c", {}, k.segment("c"), {}});
  EXPECT_OPEN(k.finding(Roots{}), "a system with functions");
}

}  // namespace
}  // namespace seam::check::test
