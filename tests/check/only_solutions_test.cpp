// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <gtest/gtest.h>

#include "builder.h"

namespace seam::check::test {
namespace {

using Kind = EliminationStep::Kind;

EliminationStep product(Combination combination, std::vector<EliminationFactor> factors) {
  EliminationStep step;
  step.combination = std::move(combination);
  step.factors = std::move(factors);
  return step;
}
EliminationStep cases(Term formula) {
  EliminationStep step;
  step.kind = Kind::cases;
  step.formula = formula;
  return step;
}
EliminationStep solution(int index, std::vector<int> equations) {
  EliminationStep step;
  step.kind = Kind::solution;
  step.index = index;
  step.equations = std::move(equations);
  return step;
}
EliminationFactor a_case(Term formula, int power = 1) {
  return {formula, power, -1, {}};
}
EliminationFactor by_condition(Term formula, int condition) {
  return {formula, 1, condition, {}};
}
EliminationFactor by_trees(Term formula, std::vector<SignProof> trees) {
  return {formula, 1, -1, std::move(trees)};
}

// One unknown x, a parameter c in (0, 1].
struct OnlySolutionsRule : testing::Test {
  Case k;
  Term c = k.symbol("c"), x = k.symbol("x"), one = k.number(1), nil = k.number(0);
  Term x_less_c = k.difference(x, c);
  Term shared = k.product({x, x_less_c});

  OnlySolutions stated(Term system, std::vector<Term> numerators,
                       std::vector<Constraint> where = {}) {
    OnlySolutions only{{system}, {"x"}, {}, {{k.segment("c", "0", "1", true)}, where}, {}};
    for (const Term numerator : numerators) only.solutions.push_back({{numerator}, {one}});
    return only;
  }
  Finding found(const OnlySolutions& only, std::vector<EliminationStep> steps) {
    k.claim(only);
    return k.finding(Elimination{std::move(steps)});
  }
  std::vector<EliminationStep> two_cases() {
    return {product({{0}, {one}}, {a_case(x), a_case(x_less_c)}), solution(0, {1}),
            solution(1, {1})};
  }
};

TEST_F(OnlySolutionsRule, a_product_falls_into_its_cases) {
  EXPECT_HOLDS(found(stated(shared, {nil, c}), two_cases()));
}

TEST_F(OnlySolutionsRule, a_changed_cofactor_is_rejected) {
  auto steps = two_cases();
  steps[0].combination.cofactors = {c};
  EXPECT_OPEN(found(stated(shared, {nil, c}), steps), "not the product");
}

TEST_F(OnlySolutionsRule, a_dropped_case_is_rejected) {
  auto steps = two_cases();
  steps.pop_back();
  EXPECT_OPEN(found(stated(shared, {nil, c}), steps), "lacks a case");
  steps = two_cases();
  steps[0].factors.pop_back();
  EXPECT_OPEN(found(stated(shared, {nil, c}), steps), "not the product");
}

TEST_F(OnlySolutionsRule, a_step_too_many_is_rejected) {
  auto steps = two_cases();
  steps.push_back(solution(0, {1}));
  EXPECT_OPEN(found(stated(shared, {nil, c}), steps), "too many");
}

TEST_F(OnlySolutionsRule, a_leaf_that_points_at_another_solution_is_rejected) {
  auto steps = two_cases();
  steps[2].index = 0;
  EXPECT_OPEN(found(stated(shared, {nil, c}), steps), "does not say what an unknown is");
  steps[2].index = 2;
  EXPECT_OPEN(found(stated(shared, {nil, c}), steps), "a solution that is none");
}

TEST_F(OnlySolutionsRule, an_equation_of_another_case_is_unknown) {
  auto steps = two_cases();
  steps[2].equations = {2};
  EXPECT_OPEN(found(stated(shared, {nil, c}), steps), "an equation that is none");
}

TEST_F(OnlySolutionsRule, a_factor_that_vanishes_nowhere_is_cancelled) {
  const Term formula = k.product({c, x_less_c});
  EXPECT_HOLDS(found(
      stated(formula, {c}),
      {product({{0}, {one}}, {by_trees(c, {nonzero(Relation::positive)}), a_case(x_less_c)}),
       solution(0, {1})}));
}

TEST_F(OnlySolutionsRule, a_factor_that_vanishes_in_the_domain_is_not) {
  const Term twice = k.difference(k.scaled(2, c), one);
  const Term formula = k.product({twice, x_less_c});
  for (const Relation side : {Relation::positive, Relation::negative})
    EXPECT_OPEN(
        found(stated(formula, {c}),
              {product({{0}, {one}}, {by_trees(twice, {nonzero(side)}), a_case(x_less_c)}),
               solution(0, {1})}),
        "do not show the sign");
}

TEST_F(OnlySolutionsRule, a_condition_excludes_a_factor) {
  const Constraint not_zero{x, Relation::nonzero};
  const std::vector<EliminationStep> steps = {
      product({{0}, {one}}, {by_condition(x, 0), a_case(x_less_c)}), solution(0, {1})};
  EXPECT_HOLDS(found(stated(shared, {c}, {not_zero}), steps));
  EXPECT_HOLDS(found(stated(shared, {c}, {{x, Relation::positive}}), steps));
  EXPECT_OPEN(found(stated(shared, {c}, {{x, Relation::nonnegative}}), steps),
              "no condition says");
  EXPECT_OPEN(found(stated(shared, {c}, {{c, Relation::nonzero}}), steps), "no condition says");
  EXPECT_OPEN(found(stated(shared, {c}), steps), "a condition that is none");
}

TEST_F(OnlySolutionsRule, an_unbounded_unknown_takes_two_trees) {
  const Term formula = k.sum({k.power(x, 2), one});
  const Pieces tree = nonzero(Relation::positive);
  const OnlySolutions none = stated(formula, {});
  EXPECT_HOLDS(found(none, {product({{0}, {one}}, {by_trees(formula, {tree, tree})})}));
  EXPECT_OPEN(found(none, {product({{0}, {one}}, {by_trees(formula, {tree})})}),
              "not one tree for each side");
}

TEST_F(OnlySolutionsRule, a_linear_factor_does_not_vanish_on_one_side_alone) {
  const Term formula = k.sum({x, one});
  const Pieces tree = nonzero(Relation::positive);
  EXPECT_OPEN(
      found(stated(formula, {}), {product({{0}, {one}}, {by_trees(formula, {tree, tree})})}),
      "do not show the sign");
}

TEST_F(OnlySolutionsRule, a_distinction_gives_an_equation_or_a_condition) {
  const std::vector<EliminationStep> steps = {
      cases(x), solution(0, {1}), product({{0}, {one}}, {by_condition(x, 0), a_case(x_less_c)}),
      solution(1, {1})};
  EXPECT_HOLDS(found(stated(shared, {nil, c}), steps));
  auto exchanged = steps;
  std::swap(exchanged[1], exchanged[3]);
  EXPECT_OPEN(found(stated(shared, {nil, c}), exchanged), "");
}

struct Outside : OnlySolutionsRule {
  // x + 1 = 0 where x >= 0: 1 * x = (x + 1) - 1.
  Term formula = k.sum({x, one}), minus_one = k.number(-1);
  EliminationStep step() {
    EliminationStep result;
    result.kind = Kind::outside;
    result.formula = one;
    result.combination = {{0}, {one}};
    result.remainder = minus_one;
    result.positive = {pieces({plain()})};
    result.broken = {pieces({plain()})};
    return result;
  }
};

TEST_F(Outside, a_condition_is_broken) {
  EXPECT_HOLDS(found(stated(formula, {}, {{x, Relation::nonnegative}}), {step()}));
}

TEST_F(Outside, a_condition_that_holds_is_not) {
  EXPECT_OPEN(found(stated(formula, {}, {{x, Relation::nonpositive}}), {step()}),
              "do not show the sign");
}

TEST_F(Outside, a_multiplier_is_positive) {
  EliminationStep turned = step();
  turned.formula = minus_one;
  turned.combination.cofactors = {minus_one};
  turned.remainder = one;
  EXPECT_OPEN(found(stated(formula, {}, {{x, Relation::nonnegative}}), {turned}),
              "do not show the sign");
}

TEST_F(Outside, a_changed_remainder_is_rejected) {
  EliminationStep changed = step();
  changed.remainder = k.number(-2);
  EXPECT_OPEN(found(stated(formula, {}, {{x, Relation::nonnegative}}), {changed}),
              "not the combination");
}

TEST_F(OnlySolutionsRule, a_witness_is_a_further_solution) {
  const Term half = k.number("1/2");
  const auto at = [&](Term at_c, Term at_x) { return Witness{{{"c", "x"}, {at_c, at_x}}, {}}; };
  k.claim(stated(shared, {nil}));
  EXPECT_FAILS(k.finding(at(half, half)));
  EXPECT_OPEN(k.finding(at(half, nil)), "one of those that are stated");
  EXPECT_OPEN(k.finding(at(half, one)), "no solution");
  EXPECT_OPEN(k.finding(at(nil, nil)), "outside the domain");
  EXPECT_OPEN(k.finding(Witness{{{"x"}, {half}}, {}}), "lacks a value");
  k.claim(stated(shared, {nil}, {{x, Relation::negative}}));
  EXPECT_OPEN(k.finding(at(half, half)), "breaks a condition");
}

TEST_F(OnlySolutionsRule, a_solution_holds_parameters_alone) {
  EXPECT_OPEN(found(stated(shared, {x}), {}), "holds more than parameters");
}

TEST_F(OnlySolutionsRule, a_root_of_a_function_is_what_its_square_says) {
  const Term s = k.symbol("s");
  k.statement.functions = {{"s", k.difference(one, k.power(c, 2)), 2}};
  const Term circle = k.sum({k.power(x, 2), k.power(c, 2), k.number(-1)});
  const Term minus_s = k.scaled(-1, s), plus = k.sum({x, s}), minus = k.difference(x, s);
  const std::vector<EliminationStep> steps = {
      product({{0}, {one}}, {a_case(minus), a_case(plus)}), solution(0, {1}), solution(1, {1})};
  EXPECT_HOLDS(found(stated(circle, {s, minus_s}), steps));
  EXPECT_OPEN(found(stated(circle, {s, s}), steps), "does not say what an unknown is");
}

TEST_F(OnlySolutionsRule, a_function_is_one_of_the_variables_of_the_domain) {
  const Term s = k.symbol("s");
  k.statement.functions = {{"s", k.symbol("u"), 2}};
  OnlySolutions only = stated(k.product({s, x}), {nil});
  only.for_all = {"u"};
  EXPECT_OPEN(found(only, {product({{0}, {one}}, {a_case(s), a_case(x)})}),
              "a variable outside the domain");
}

TEST_F(OnlySolutionsRule, no_step_shows_nothing) {
  EXPECT_OPEN(found(stated(shared, {nil, c}), {}), "lacks a case");
}

}  // namespace
}  // namespace seam::check::test
