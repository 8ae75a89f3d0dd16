// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "symbolic/approximate.h"
#include "symbolic/atoms.h"
#include "symbolic/coefficients.h"

namespace seam::symbolic {
namespace {

const Formula c = Formula::symbol("c"), u = Formula::symbol("u");
Formula sine() {
  return root(Formula(1) - power(c, 2), 2);
}

TEST(FunctionFormula, PowersOfARootAreReducedByItsRadicand) {
  const Numbers numbers;
  EXPECT_TRUE(vanishes(power(sine(), 4) - power(Formula(1) - power(c, 2), 2), numbers));
  EXPECT_FALSE(vanishes(sine() - Formula(1) + c, numbers));
}

TEST(FunctionFormula, RootsUnderRootsAreReducedToo) {
  const Numbers numbers;
  const Formula nested = root(Formula(1) + sine() * power(c, 2), 2);
  const Formula square = Formula(1) + power(c, 2) * sine();
  EXPECT_TRUE(vanishes(power(nested, 2) - square, numbers));
  EXPECT_TRUE(vanishes(power(nested, 4) - power(square, 2), numbers));
}

TEST(FunctionFormula, SquaringARootDoesNotForgetItsSign) {
  const Numbers numbers;
  EXPECT_FALSE(vanishes(root(power(c, 2), 2) - c, numbers));
}

TEST(FunctionFormula, CoefficientsHoldTheRootsAndInversesOfOtherSymbols) {
  const Numbers numbers;
  const Formula below = inverse(Formula(4) - Formula(3) * power(c, 2));
  const auto found = coefficients(power(sine() + u, 2) * below, {"u"}, numbers);
  ASSERT_EQ(found.size(), 3u);
  EXPECT_TRUE(vanishes(found.at({1}) - Formula(2) * sine() * below, numbers));
  EXPECT_TRUE(vanishes(found.at({0}) - (Formula(1) - power(c, 2)) * below, numbers));
}

TEST(FunctionFormula, ARootOfTheVariableItselfHasNoCoefficientsInIt) {
  const Numbers numbers;
  EXPECT_THROW(coefficients(sine() + c, {"c"}, numbers), FormulaLimit);
  EXPECT_THROW(coefficients(inverse(c), {"c"}, numbers), FormulaLimit);
}

TEST(FunctionFormula, DerivativesFollowTheChainRule) {
  const Numbers numbers;
  const std::map<std::string, double> at = {{"c", 0.6}};
  EXPECT_NEAR(approximate(diff(sine(), "c"), at, numbers), -0.6 / 0.8, 1e-12);
  EXPECT_NEAR(approximate(diff(inverse(sine()), "c"), at, numbers), 0.6 / std::pow(0.8, 3),
              1e-12);
}

TEST(FunctionFormula, AValueThatRestsOnAConditionKeepsItUnderSubstitution) {
  const Formula zero = Formula::known(Formula(0), {{c, Fact::Relation::nonzero}});
  const Formula moved = subst(zero, {{"c", u}});
  ASSERT_EQ(moved.kind(), Formula::Kind::known);
  EXPECT_TRUE(moved.facts().front().formula.same(u));
  EXPECT_FALSE(moved.is_polynomial());
}

TEST(FunctionFormula, EqualRootsHaveOneNameAndDifferentRootsHaveTwo) {
  Atoms atoms;
  atoms.add(sine() * sine() + root(power(c, 2), 2));
  ASSERT_EQ(atoms.entries().size(), 2u);
  EXPECT_NE(atoms.entries()[0].name, atoms.entries()[1].name);
  EXPECT_EQ(atoms[sine()].name, atoms.entries()[0].name);
}

TEST(FunctionFormula, AnInnerRootComesBeforeTheOuterOne) {
  Atoms atoms;
  const Formula outer = root(Formula(2) + sine(), 2);
  atoms.add(outer);
  ASSERT_EQ(atoms.entries().size(), 2u);
  EXPECT_TRUE(atoms.entries()[1].formula.same(outer));
}

TEST(FunctionFormula, ElementaryFunctionsHaveTheirDerivatives) {
  const Numbers numbers;
  const Formula wave = Formula::applied("sin", {Formula(3) * c});
  const Formula growth = Formula::applied("exp", {power(c, 2)});
  const std::map<std::string, double> at = {{"c", 0.4}};
  EXPECT_NEAR(approximate(diff(wave, "c"), at, numbers), 3 * std::cos(1.2), 1e-12);
  EXPECT_NEAR(approximate(diff(diff(wave, "c"), "c"), at, numbers), -9 * std::sin(1.2), 1e-12);
  EXPECT_NEAR(approximate(diff(growth, "c"), at, numbers), 0.8 * std::exp(0.16), 1e-12);
  EXPECT_NEAR(approximate(diff(Formula::applied("log", {c}), "c"), at, numbers), 2.5, 1e-12);
}

TEST(FunctionFormula, AnArbitraryFunctionHasIndependentDerivatives) {
  const Formula f = Formula::applied("f", {Formula(2) * c});
  const Formula derived = Formula(2) * Formula::applied("f", {Formula(2) * c}, {1});
  EXPECT_TRUE(diff(f, "c").same(derived));
  EXPECT_TRUE(diff(f, "u").is(0));
  EXPECT_EQ(text(diff(f, "c")), "2*f'(2*c)");
  const Formula g = Formula::applied("g", {c, u});
  EXPECT_EQ(text(diff(diff(g, "u"), "c")), "D(g, 1, 1)(c, u)");
  EXPECT_EQ(text(subst(g, {{"u", Formula(1)}})), "g(c, 1)");
}

TEST(FunctionFormula, ItsTextKeepsSignsAndParentheses) {
  const Formula v = Formula::symbol("v"), e = Formula::applied("exp", {c});
  EXPECT_EQ(text(v - (c + u)), "v - (c + u)");
  EXPECT_EQ(text(-(c + u)), "-(c + u)");
  EXPECT_EQ(text(-(-e)), "-(-exp(c))");
  EXPECT_EQ(text(v - (-e)), "v - (-exp(c))");
  EXPECT_EQ(text(v * -e), "v*(-exp(c))");
  EXPECT_EQ(text(v - Formula(exact::Rational(1, 2)) * c), "v - (1/2)*c");
  EXPECT_EQ(text(v - Formula(exact::Rational(1, 2))), "v - 1/2");
}

}  // namespace
}  // namespace seam::symbolic
