// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <gtest/gtest.h>

#include <tuple>
#include <utility>
#include <vector>

#include "builder.h"

namespace seam::check::test {
namespace {

using enum Relation;
using enum Reduction::Kind;

Reduction by_multiplier(Term h, SignProof is_positive, SignProof product) {
  return {multiplier, {h}, {}, {std::move(is_positive), std::move(product)}};
}

/// k - r with k = 1 + c^2 and r = sqrt(k^2 - c^2) for c in [0, 1].
struct Difference : Case {
  Term c = symbol("c"), r = symbol("r");
  Term k = sum({number(1), power(c, 2)});
  Difference(Relation relation, bool open) {
    statement.functions = {{"r", difference(power(k, 2), power(c, 2)), 2}};
    claim(Sign{difference(k, r), relation, {{segment("c", "0", "1", open)}, {}}});
    evidence_begins();
  }
  Reduction conjugate() {
    return by_multiplier(sum({k, r}), pieces({plain()}), pieces({plain()}));
  }
};

TEST(Multiplier, a_root_goes_out_by_its_conjugate) {
  for (const auto& [relation, open, holds] :
       std::vector<std::tuple<Relation, bool, bool>>{{positive, true, true},
                                                     {positive, false, false},  // 0 at c = 0
                                                     {nonnegative, false, true},
                                                     {negative, true, false}}) {
    Difference d(relation, open);
    if (holds)
      EXPECT_HOLDS(d.finding(d.conjugate()));
    else
      EXPECT_OPEN(d.finding(d.conjugate()), "do not show the sign");
  }
}

TEST(Multiplier, it_must_be_positive) {
  Difference d(positive, true);
  EXPECT_OPEN(
      d.finding(by_multiplier(d.difference(d.k, d.r), pieces({plain()}), pieces({plain()}))),
      "do not show the sign");
  EXPECT_OPEN(d.finding(by_multiplier(d.number(0), Computation{}, Computation{})),
              "no number of this sign");
  EXPECT_OPEN(d.finding(by_multiplier(d.number(-1), Computation{}, pieces({plain()}))),
              "no number of this sign");
}

TEST(Multiplier, another_multiplier_gives_another_product) {
  Difference d(positive, true);
  const Term h = d.sum({d.k, d.r, d.number(1)});
  EXPECT_OPEN(d.finding(by_multiplier(h, pieces({plain()}), pieces({plain()}))), "do not show");
}

TEST(Multiplier, it_holds_variables_and_functions_of_the_obligation_alone) {
  Difference d(positive, true);
  d.statement.functions.push_back({"s", d.c, 2});
  for (const char* other : {"x", "s"}) {
    const Term h = d.sum({d.k, d.r, d.symbol(other)});
    EXPECT_OPEN(d.finding(by_multiplier(h, pieces({plain()}), pieces({plain()}))),
                "a variable outside the domain");
  }
}

TEST(Multiplier, it_may_be_of_any_sign_where_no_sign_is_claimed) {
  Difference d(nonzero, true);
  EXPECT_HOLDS(d.finding(
      by_multiplier(d.scaled(-1, d.sum({d.k, d.r})), Computation{}, test::nonzero(negative))));
  EXPECT_OPEN(d.finding(by_multiplier(d.number(0), Computation{}, Computation{})),
              "no number of this sign");
  Difference closed(nonzero, false);
  EXPECT_OPEN(closed.finding(by_multiplier(closed.scaled(-1, closed.sum({closed.k, closed.r})),
                                           Computation{}, test::nonzero(negative))),
              "do not show the sign");
}

TEST(Multiplier, an_equation_holds_where_a_positive_multiple_of_it_does) {
  for (const int constant : {1, 2}) {
    Case k;  // r = 1 + c where r^2 = (1 + c)^2
    const Term c = k.symbol("c"), r = k.symbol("r");
    const Term root = k.sum({c, k.number(1)});
    k.statement.functions = {{"r", k.power(root, 2), 2}};
    const Term f = k.sum({r, k.scaled(-1, c), k.number(-constant)});
    k.claim(Sign{f, zero, {{k.segment("c")}, {}}});
    k.evidence_begins();
    const Reduction proof = by_multiplier(k.sum({r, root}), pieces({plain()}), Computation{});
    if (constant == 1)
      EXPECT_HOLDS(k.finding(proof));
    else
      EXPECT_OPEN(k.finding(proof), "no number of this sign");
    EXPECT_OPEN(k.finding(Computation{}), "depends on variables");
    EXPECT_OPEN(k.finding(pieces({plain()})), "do not show the sign");
  }
}

/// (x - 1/2)^2 + side * r >= 0 for x in [0, 1], r = sqrt((x - 1/2)^4 * scale).
struct Touching : Case {
  Term x = symbol("x"), r = symbol("r");
  Term a = power(sum({x, number("-1/2")}), 2);
  Term f;
  Touching(Relation relation, const char* scale) {
    statement.functions = {{"r", product({power(a, 2), number(scale)}), 2}};
    f = difference(a, r);
    claim(Sign{f, relation, {{segment("x")}, {}}});
    evidence_begins();
  }
  Pieces square(const char* cofactor, Term root) {
    return {{plain()}, positive, root, number(cofactor)};
  }
  Reduction proof(Pieces product) {
    Pieces sum_is = {{plain()}, positive, sum({x, number("-1/2")}), number(2)};
    return {conjugate, {sum({a, r})}, {}, {sum_is, std::move(product)}};
  }
};

TEST(Conjugate, two_numbers_with_sum_and_product_not_negative_are_not_negative) {
  Touching t(nonnegative, "1/4");
  EXPECT_HOLDS(t.finding(t.proof(t.square("3/4", t.a))));
  Touching larger(nonnegative, "4");
  EXPECT_OPEN(larger.finding(larger.proof(larger.square("-3", larger.a))), "do not show");
  EXPECT_OPEN(larger.finding(larger.proof(larger.square("3/4", larger.a))), "the square times");
  Touching strict(positive, "1/4");
  EXPECT_OPEN(strict.finding(strict.proof(strict.square("3/4", strict.a))), "no strict sign");
  Touching equation(zero, "1");
  EXPECT_OPEN(equation.finding(equation.proof(equation.square("0", equation.a))),
              "a conjugate shows neither");
}

TEST(Conjugate, the_sum_is_needed) {
  for (const auto& [relation, value, holds] :
       std::vector<std::tuple<Relation, const char*, bool>>{{positive, "2", true},
                                                            {positive, "-2", false},
                                                            {negative, "-2", true},
                                                            {negative, "2", false},
                                                            {nonpositive, "-2", true}}) {
    Case k;  // 2 > 0, as 2 + 1 >= 0 and 2 * 1 > 0
    k.claim(Sign{k.number(value), relation, {}});
    k.evidence_begins();
    const Term h = k.number(value[0] == '-' ? -1 : 1);
    const Finding found =
        k.finding(Reduction{conjugate, {h}, {}, {Computation{}, Computation{}}});
    if (holds)
      EXPECT_HOLDS(found);
    else
      EXPECT_OPEN(found, "no number of this sign");
  }
}

TEST(Both, what_is_not_negative_and_not_positive_is_zero) {
  Case k;  // x = 0 for x in [0, 1] where x <= 0
  const Term x = k.symbol("x");
  k.claim(Sign{x, zero, {{k.segment("x")}, {{x, nonpositive}}}});
  k.evidence_begins();
  const Reduction below{combination, {k.number(1)}, {0}, {Computation{}, Computation{}}};
  EXPECT_HOLDS(k.finding(Reduction{both, {}, {}, {pieces({plain()}), below}}));
  EXPECT_OPEN(k.finding(Reduction{both, {}, {}, {pieces({plain()}), pieces({plain()})}}), "");
  EXPECT_OPEN(k.finding(Reduction{both, {}, {}, {below, pieces({plain()})}}), "");
  std::get<Sign>(k.statement.obligations[0]).relation = nonnegative;
  EXPECT_OPEN(k.finding(Reduction{both, {}, {}, {pieces({plain()}), below}}),
              "two proofs for one relation");
}

TEST(Cases, both_are_needed) {
  Case k;
  const Term x = k.symbol("x");
  k.claim(Sign{k.power(x, 2), nonnegative, {{k.segment("x", "-1")}, {}}});
  k.evidence_begins();
  // For x >= 0: x^2 = x * x with x >= 0 as cofactor; for x <= 0 likewise.
  const Term minus = k.scaled(-1, k.number(1));
  const Reduction above{
      combination,
      {x},
      {0},
      {Computation{},
       Reduction{combination, {k.number(1)}, {0}, {Computation{}, Computation{}}}}};
  const Reduction below = above;
  const Reduction proof{cases, {x}, {}, {above, below}};
  EXPECT_HOLDS(k.finding(proof));
  Reduction half = proof;
  half.parts[1] = Computation{};
  EXPECT_OPEN(k.finding(half), "no number of this sign");
  half = proof;
  half.parts[0] = Computation{};
  EXPECT_OPEN(k.finding(half), "no number of this sign");
  half = proof;
  half.terms[0] = k.product({x, minus});  // the cases change places
  EXPECT_OPEN(k.finding(half), "no number of this sign");
}

TEST(Cases, a_condition_of_a_case_holds_in_that_case_alone) {
  Case k;
  const Term x = k.symbol("x");
  k.claim(Sign{x, nonnegative, {{k.segment("x", "-1")}, {}}});
  k.evidence_begins();
  const Reduction shown{combination, {k.number(1)}, {0}, {Computation{}, Computation{}}};
  EXPECT_OPEN(k.finding(Reduction{cases, {x}, {}, {shown, shown}}), "no number of this sign");
  EXPECT_OPEN(k.finding(shown), "a condition that is none");
}

TEST(Cases, a_case_that_does_not_occur_shows_everything) {
  for (const char* low : {"0", "-1"}) {
    Case k;  // x >= 0 by the condition of the first case; the second is empty if low = 0
    const Term x = k.symbol("x");
    k.claim(Sign{x, nonnegative, {{k.segment("x", low)}, {}}});
    k.evidence_begins();
    const Reduction above{combination, {k.number(1)}, {0}, {Computation{}, Computation{}}};
    const Finding found = k.finding(Reduction{cases, {x}, {}, {above, pieces({outside(0)})}});
    if (low[0] == '0')
      EXPECT_HOLDS(found);
    else
      EXPECT_OPEN(found, "not seen to be broken");
  }
}

TEST(Combination, an_equation_may_be_added_any_number_of_times) {
  for (const auto& [relation, holds] : std::vector<std::pair<Relation, bool>>{
           {zero, true}, {nonnegative, false}, {nonzero, false}}) {
    Case k;  // x^4 - y^2 = 0 where x^2 + y = 0: the cofactor is x^2 - y
    const Term x = k.symbol("x"), y = k.symbol("y");
    const Term f = k.difference(k.power(x, 4), k.power(y, 2));
    k.claim(Sign{f,
                 zero,
                 {{k.segment("x", "-1"), k.segment("y", "-1")},
                  {{k.sum({k.power(x, 2), y}), relation}}}});
    k.evidence_begins();
    const Term cofactor = k.difference(k.power(x, 2), y);
    const Reduction proof{combination, {cofactor}, {0}, {Computation{}}};
    if (holds)
      EXPECT_HOLDS(k.finding(proof));
    else
      EXPECT_OPEN(k.finding(proof), "does not help this relation");
    Reduction wrong = proof;
    wrong.terms[0] = k.sum({k.power(x, 2), y});
    EXPECT_OPEN(k.finding(wrong), holds ? "no number of this sign" : "does not help");
    wrong = proof;
    wrong.conditions[0] = 1;
    EXPECT_OPEN(k.finding(wrong), "a condition that is none");
    wrong = proof;
    wrong.parts.clear();
    EXPECT_OPEN(k.finding(wrong), "");
  }
}

TEST(Combination, an_inequality_is_added_with_a_cofactor_of_its_sign) {
  Case k;  // x + y > 0 where x > 0 and y - 1 >= 0, and where 1 - y <= 0
  const Term x = k.symbol("x"), y = k.symbol("y"), one = k.number(1);
  const std::vector<Constraint> where = {{x, positive},
                                         {k.difference(y, one), nonnegative},
                                         {k.difference(one, y), nonpositive},
                                         {k.difference(one, y), nonzero}};
  k.claim(Sign{
      k.sum({x, y}), positive, {{k.segment("x", "-1"), k.segment("y", "-2", "2")}, where}});
  k.evidence_begins();
  const Term minus = k.number(-1);
  const Computation computed;
  EXPECT_HOLDS(
      k.finding(Reduction{combination, {one, one}, {0, 1}, {computed, computed, computed}}));
  EXPECT_HOLDS(
      k.finding(Reduction{combination, {one, minus}, {0, 2}, {computed, computed, computed}}));
  EXPECT_OPEN(
      k.finding(Reduction{combination, {one, one}, {0, 2}, {computed, computed, computed}}),
      "no number of this sign");
  EXPECT_OPEN(k.finding(Reduction{combination, {one, one}, {0, 1}, {computed, computed}}),
              "lacks a proof of its sign");
  EXPECT_OPEN(
      k.finding(Reduction{combination, {one, minus}, {0, 3}, {computed, computed, computed}}),
      "does not help");
  EXPECT_OPEN(
      k.finding(Reduction{combination, {one}, {0}, {pieces({plain()}), computed, computed}}),
      "not one proof");
}

TEST(Combination, an_inequality_does_not_help_an_equation) {
  Case k;
  const Term x = k.symbol("x");
  k.claim(Sign{x, zero, {{k.segment("x")}, {{x, nonnegative}}}});
  k.evidence_begins();
  EXPECT_OPEN(
      k.finding(Reduction{combination, {k.number(1)}, {0}, {Computation{}, Computation{}}}),
      "does not help this relation");
}

TEST(Reduction, a_region_without_points_shows_no_more_than_it_says) {
  Case k;
  const Term x = k.symbol("x");
  k.claim(Sign{x, positive, {{k.segment("x")}, {{x, zero}}}});  // fails at 0
  k.evidence_begins();
  EXPECT_OPEN(k.finding(pieces({plain()})), "do not show the sign");
  EXPECT_OPEN(k.finding(pieces({outside(0)})), "not seen to be broken");
  EXPECT_FAILS(k.finding(Witness{{{"x"}, {k.number(0)}}, {}}));
}

}  // namespace
}  // namespace seam::check::test
