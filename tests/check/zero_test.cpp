// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <gtest/gtest.h>

#include "builder.h"

namespace seam::check::test {
namespace {

TEST(Zero, an_identity_is_proven_by_its_normal_form) {
  Case c;
  const Term x = c.symbol("x");
  const Term y = c.symbol("y");
  const Term left = c.power(c.sum({x, y}), 5);
  const Term right = c.sum({c.power(x, 5), c.scaled(5, c.product({c.power(x, 4), y})),
                            c.scaled(10, c.product({c.power(x, 3), c.power(y, 2)})),
                            c.scaled(10, c.product({c.power(x, 2), c.power(y, 3)})),
                            c.scaled(5, c.product({x, c.power(y, 4)})), c.power(y, 5)});
  c.claim(Zero{c.difference(left, right)});
  EXPECT_HOLDS(c.finding(Computation{}));
  c.claim(Zero{c.difference(c.scaled(2, left), right)});
  EXPECT_FAILS(c.finding(Computation{}));
}

TEST(Zero, empty_sums_and_products_and_powers_have_their_values) {
  Case c;
  c.claim(Zero{c.sum({})});
  EXPECT_HOLDS(c.finding(Computation{}));
  c.claim(Zero{c.difference(c.product({}), c.power(c.number(0), 0))});  // 1 - 1
  EXPECT_HOLDS(c.finding(Computation{}));
  c.claim(Zero{c.difference(c.power(c.symbol("x"), 0), c.number(1))});
  EXPECT_HOLDS(c.finding(Computation{}));
}

TEST(Zero, fractions_are_added_exactly) {
  Case c;
  c.claim(Zero{c.sum({c.number("1/6"), c.number("1/10"), c.number("1/15"), c.number("-1/3")})});
  EXPECT_HOLDS(c.finding(Computation{}));
}

TEST(Zero, a_witness_refutes_where_the_value_is_not_zero) {
  Case c;
  const Term x = c.symbol("x");
  const Term y = c.symbol("y");
  c.claim(Zero{c.difference(x, y)});
  const Term one = c.number(1);
  const Term two = c.number(2);
  EXPECT_FAILS(c.finding(Witness{{{"x", "y"}, {one, two}}, {}}));
  EXPECT_OPEN(c.finding(Witness{{{"x", "y"}, {two, two}}, {}}), "0 at the witness");
  EXPECT_OPEN(c.finding(Witness{{{"x"}, {two}}, {}}), "lacks a value");
  EXPECT_OPEN(c.finding(Witness{{{"x", "x"}, {one, two}}, {}}), "two values");
  EXPECT_OPEN(c.finding(Witness{{{"x", "y"}, {one, x}}, {}}), "variable");
  EXPECT_OPEN(c.finding(Witness{{{"x", "z"}, {one, two}}, {}}), "unknown variable");
}

TEST(Zero, evidence_of_another_kind_shows_nothing) {
  Case c;
  c.claim(Zero{c.number(0)});
  EXPECT_OPEN(c.finding(pieces({plain()})), "says nothing");
  EXPECT_OPEN(c.finding(WrongSolution{}), "says nothing");
  EXPECT_OPEN(c.finding(Roots{}), "says nothing");
  EXPECT_OPEN(c.finding(Nothing{"time", "the clock"}), "time: the clock");
}

}  // namespace
}  // namespace seam::check::test
