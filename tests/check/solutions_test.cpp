// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <gtest/gtest.h>

#include "builder.h"

namespace seam::check::test {
namespace {

// (x^2 - 1/4) (x + 1) = 0 on [0, 1] gives 1/2, with its evidence.
struct Exact : Case {
  Term x, formula, half, third, minus;
  Roots roots;

  explicit Exact(bool open_low = false, bool open_high = false) {
    x = symbol("x");
    formula = product({polynomial(x, {"-1/4", "0", "1"}), polynomial(x, {"1", "1"})});
    half = number("1/2");
    third = number("1/3");
    minus = number(-1);
    claim(Solutions{
        {formula}, "x", {}, segment("x", "0", "1", open_low, open_high), {{half, {}, {}}}});
    evidence_begins();
    roots.divisor = formula;
    roots.cofactors = roots.quotients = {number(1)};
    roots.multiplicities = {1};
    roots.rest = product({polynomial(x, {"1/2", "1"}), polynomial(x, {"1", "1"})});
    roots.outside = {nonzero(Relation::positive)};
  }
  Solutions& stated() { return std::get<Solutions>(statement.obligations.front()); }
};

TEST(Solutions, exact_ones_are_proven) {
  Exact c;
  EXPECT_HOLDS(c.finding(c.roots));
}

TEST(Solutions, a_missing_solution_is_rejected_and_refuted) {
  Exact c;
  c.stated().solutions = {};
  c.roots.multiplicities = {};
  EXPECT_OPEN(c.finding(c.roots), "product");
  c.roots.rest = c.formula;
  EXPECT_OPEN(c.finding(c.roots), "do not show");
  EXPECT_FAILS(c.finding(WrongSolution{c.half, -1}));
}

TEST(Solutions, one_that_is_none_is_rejected_and_refuted) {
  Exact c;
  c.stated().solutions.push_back({c.third, {}, {}});
  c.roots.multiplicities = {1, 1};
  EXPECT_OPEN(c.finding(c.roots), "product");
  EXPECT_FAILS(c.finding(WrongSolution{0, 1}));
  EXPECT_OPEN(c.finding(WrongSolution{0, 0}), "wrong or missing");
  EXPECT_OPEN(c.finding(WrongSolution{0, 2}), "none");
  EXPECT_OPEN(c.finding(WrongSolution{c.half, -1}), "wrong or missing");
}

TEST(Solutions, a_multiplicity_of_zero_hides_no_false_solution) {
  Exact c;
  c.stated().solutions.push_back({c.third, {}, {}});
  c.roots.multiplicities = {1, 0};
  EXPECT_OPEN(c.finding(c.roots), "multiplicity");
  c.roots.multiplicities = {1, -1};
  EXPECT_OPEN(c.finding(c.roots), "multiplicity");
}

TEST(Solutions, one_given_twice_is_rejected) {
  Exact c;
  c.stated().solutions.push_back(c.stated().solutions.front());
  c.roots.multiplicities = {1, 1};
  EXPECT_OPEN(c.finding(c.roots), "two roots are one");
}

TEST(Solutions, one_outside_the_domain_is_rejected_and_refuted) {
  Exact c;
  c.stated().solutions.push_back({c.minus, {}, {}});
  c.roots.multiplicities = {1, 1};
  EXPECT_OPEN(c.finding(c.roots), "outside the domain");
  EXPECT_FAILS(c.finding(WrongSolution{0, 1}));
  // -1/2 is a root, but not one that the domain misses.
  c.stated().solutions.pop_back();
  EXPECT_OPEN(c.finding(WrongSolution{c.number("-1/2"), -1}), "wrong or missing");
}

TEST(Solutions, a_false_divisor_is_rejected) {
  Exact c;
  Roots forged = c.roots;
  forged.divisor = c.product({c.formula, c.polynomial(c.x, {"-1/3", "1"})});
  EXPECT_OPEN(c.finding(forged), "quotient");
  forged = c.roots;
  forged.quotients = {c.number(2)};
  EXPECT_OPEN(c.finding(forged), "quotient");
  forged = c.roots;
  forged.cofactors = {c.number(2)};
  EXPECT_OPEN(c.finding(forged), "combination");
  forged.cofactors = {};
  EXPECT_OPEN(c.finding(forged), "one cofactor");
}

TEST(Solutions, a_divisor_of_too_few_roots_is_rejected) {
  // F = (x - 1/2)(x - 1/3), divisor x - 1/2: it divides F, but is no multiple of F.
  Case d;
  const Term x = d.symbol("x");
  const Term a = d.polynomial(x, {"-1/2", "1"});
  const Term b = d.polynomial(x, {"-1/3", "1"});
  d.claim(Solutions{{d.product({a, b})}, "x", {}, d.segment("x"), {{d.number("1/2"), {}, {}}}});
  Roots roots;
  roots.divisor = a;
  roots.quotients = {b};
  roots.cofactors = {d.number(1)};
  roots.multiplicities = {1};
  roots.rest = d.number(1);
  roots.outside = {nonzero(Relation::positive)};
  EXPECT_OPEN(d.finding(roots), "combination");
}

TEST(Solutions, a_rest_with_a_root_is_rejected) {
  Exact c;
  c.roots.rest = c.polynomial(c.x, {"-1/3", "1"});
  c.roots.divisor = c.formula;
  EXPECT_OPEN(c.finding(c.roots), "product");
}

TEST(Solutions, a_root_at_an_open_end_is_none) {
  for (const bool open : {true, false}) {
    Case c;
    const Term x = c.symbol("x");
    c.claim(Solutions{{x}, "x", {}, c.segment("x", "0", "1", open), {}});
    Roots roots;
    roots.divisor = roots.rest = x;
    roots.cofactors = roots.quotients = {c.number(1)};
    roots.outside = {nonzero(Relation::positive)};
    EXPECT_EQ(c.finding(roots).kind, open ? Kind::holds : Kind::open);
    EXPECT_EQ(c.finding(WrongSolution{c.number(0), -1}).kind, open ? Kind::open : Kind::fails);
  }
}

TEST(Solutions, of_a_system_that_vanishes_are_not_proven_to_be_none) {
  Case c;
  const Term nil = c.number(0);
  const Term one = c.number(1);
  for (const std::vector<Term>& system : {std::vector<Term>{}, std::vector<Term>{nil}}) {
    c.claim(Solutions{system, "x", {}, c.segment("x"), {}});
    Roots roots;
    roots.divisor = roots.rest = nil;
    roots.outside = {nonzero(Relation::positive)};
    EXPECT_OPEN(c.finding(roots), "do not show");
    roots.divisor = roots.rest = one;
    EXPECT_OPEN(c.finding(roots), "combination");
    EXPECT_FAILS(c.finding(WrongSolution{one, -1}));
  }
}

TEST(Solutions, must_hold_for_all_values_of_the_other_variables) {
  // u (x - 1) + u v (x^2 - 1) + (x - 1)(x - 2): the coefficients of 1, u, u v in (u, v) order
  Case c;
  const Term x = c.symbol("x");
  const Term u = c.symbol("u");
  const Term v = c.symbol("v");
  const Term a = c.polynomial(x, {"2", "-3", "1"});
  const Term b = c.polynomial(x, {"-1", "1"});
  const Term d = c.polynomial(x, {"-1", "0", "1"});
  const Term one = c.number(1);
  const Term nil = c.number(0);
  const Term system = c.sum({a, c.product({u, b}), c.product({u, v, d})});
  c.claim(Solutions{{system}, "x", {"u", "v"}, c.ray("x", "0"), {{one, {}, {}}}});
  Roots roots;
  roots.divisor = b;
  roots.cofactors = {nil, one, nil};
  roots.quotients = {c.polynomial(x, {"-2", "1"}), one, c.polynomial(x, {"1", "1"})};
  roots.multiplicities = {1};
  roots.rest = one;
  roots.outside = {nonzero(Relation::positive)};
  EXPECT_HOLDS(c.finding(roots));
  EXPECT_OPEN(c.finding(WrongSolution{c.number(2), -1}), "wrong or missing");
  // In another order the quotients do not fit.
  std::get<Solutions>(c.statement.obligations.front()).for_all = {"v", "u"};
  EXPECT_HOLDS(c.finding(roots));
  // A variable that is not bound is rejected, and so is the unknown bound twice.
  std::get<Solutions>(c.statement.obligations.front()).for_all = {"u"};
  EXPECT_OPEN(c.finding(roots), "not bound");
  std::get<Solutions>(c.statement.obligations.front()).for_all = {"u", "v", "x"};
  EXPECT_OPEN(c.finding(roots), "twice");
}

TEST(Solutions, coefficients_come_in_lexicographic_order_of_exponents) {
  // x u + (x - 1) v: v comes first, with exponents (0, 1).
  Case c;
  const Term x = c.symbol("x");
  const Term one = c.number(1);
  const Term minus = c.number(-1);
  const Term less = c.polynomial(x, {"-1", "1"});
  const Term system = c.sum({c.product({x, c.symbol("u")}), c.product({less, c.symbol("v")})});
  c.claim(Solutions{{system}, "x", {"u", "v"}, c.segment("x"), {}});
  Roots roots;
  roots.divisor = roots.rest = one;
  roots.cofactors = {minus, one};
  roots.quotients = {less, x};
  roots.outside = {nonzero(Relation::positive)};
  EXPECT_HOLDS(c.finding(roots));
  std::swap(roots.cofactors[0], roots.cofactors[1]);
  std::swap(roots.quotients[0], roots.quotients[1]);
  EXPECT_OPEN(c.finding(roots), "quotient");
}

TEST(Solutions, exact_ones_among_all_numbers_take_two_trees) {
  Exact c;  // (x^2 - 1/4) (x + 1)
  c.stated().domain = {{"x"}, {}, {}};
  c.stated().solutions = {{c.half, {}, {}}, {c.minus, {}, {}}};
  c.roots.multiplicities = {1, 1};
  c.roots.rest = c.polynomial(c.x, {"1/2", "1"});
  c.roots.outside = {nonzero(Relation::positive), nonzero(Relation::negative)};
  EXPECT_OPEN(c.finding(c.roots), "do not show");  // -1/2 is missing
  EXPECT_FAILS(c.finding(WrongSolution{c.number("-1/2"), -1}));

  Case d;
  const Term x = d.symbol("x");
  d.claim(Solutions{{d.product({x, d.polynomial(x, {"1", "1", "1"})})},
                    "x",
                    {},
                    {{"x"}, {}, {}},
                    {{d.number(0), {}, {}}}});
  Roots roots;
  roots.divisor = std::get<Solutions>(d.statement.obligations.front()).system.front();
  roots.cofactors = roots.quotients = {d.number(1)};
  roots.multiplicities = {1};
  roots.rest = d.polynomial(x, {"1", "1", "1"});
  const Step at_minus_1 = split(0, {d.number(1), d.number(1)});
  roots.outside = {nonzero(Relation::positive),
                   nonzero(Relation::positive, {at_minus_1, plain(), plain()})};
  EXPECT_HOLDS(d.finding(roots));
  std::swap(roots.outside[0], roots.outside[1]);
  EXPECT_OPEN(d.finding(roots), "do not show");
  roots.outside.pop_back();
  EXPECT_OPEN(d.finding(roots), "two over all numbers");
}

TEST(Solutions, a_simplex_without_corners_is_no_domain_of_a_sign) {
  Case c;
  c.claim(Sign{c.number(1), Relation::positive, {{{{"x"}, {}, {}}}, {}}});
  EXPECT_OPEN(c.finding(pieces({plain()})), "malformed");
}

}  // namespace
}  // namespace seam::check::test
