// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "check/judge.h"

#include <gtest/gtest.h>

#include <chrono>

#include "builder.h"

namespace seam::check::test {
namespace {

Goal leaf(int obligation) {
  return {Goal::Kind::obligation, {}, obligation};
}
Goal all(std::vector<Goal> parts) {
  return {Goal::Kind::all, std::move(parts), -1};
}
Goal any(std::vector<Goal> parts) {
  return {Goal::Kind::any, std::move(parts), -1};
}
Goal negation(Goal part) {
  return {Goal::Kind::negation, {std::move(part)}, -1};
}

Goal suffices(Goal part) {
  return {Goal::Kind::suffices, {std::move(part)}, -1};
}

constexpr int holds = 0, fails = 1, open = 2;

// Three obligations: one that holds, one that fails, one that stays open.
Judgement judged(Goal goal, std::vector<int> guards = {}) {
  Case c;
  const Term nil = c.number(0);
  const Term one = c.number(1);
  c.statement.obligations = {Zero{nil}, Zero{one}, Zero{nil}};
  c.statement.guards = std::move(guards);
  c.statement.goal = std::move(goal);
  c.evidence.proofs = {Computation{}, Computation{}, Nothing{"effort", "no more"}};
  return c.judged();
}

TEST(Judge, combines_in_three_values) {
  using enum Verdict;
  EXPECT_EQ(judged(leaf(holds)).verdict, proven);
  EXPECT_EQ(judged(leaf(fails)).verdict, refuted);
  EXPECT_EQ(judged(leaf(open)).verdict, undecided);
  EXPECT_EQ(judged(all({})).verdict, proven);
  EXPECT_EQ(judged(any({})).verdict, refuted);
  EXPECT_EQ(judged(negation(leaf(holds))).verdict, refuted);
  EXPECT_EQ(judged(negation(leaf(fails))).verdict, proven);
  EXPECT_EQ(judged(negation(leaf(open))).verdict, undecided);
  EXPECT_EQ(judged(all({leaf(open), leaf(fails)})).verdict, refuted);
  EXPECT_EQ(judged(all({leaf(open), leaf(holds)})).verdict, undecided);
  EXPECT_EQ(judged(all({leaf(holds), leaf(holds)})).verdict, proven);
  EXPECT_EQ(judged(any({leaf(open), leaf(holds)})).verdict, proven);
  EXPECT_EQ(judged(any({leaf(open), leaf(fails)})).verdict, undecided);
  EXPECT_EQ(judged(any({leaf(fails), leaf(fails)})).verdict, refuted);
  EXPECT_EQ(judged(negation(any({leaf(fails), negation(leaf(holds))}))).verdict, proven);
}

TEST(Judge, takes_what_suffices_for_a_proof_and_never_for_a_refutation) {
  using enum Verdict;
  EXPECT_EQ(judged(suffices(leaf(holds))).verdict, proven);
  EXPECT_EQ(judged(suffices(leaf(fails))).verdict, undecided);
  EXPECT_EQ(judged(suffices(leaf(open))).verdict, undecided);
  EXPECT_EQ(judged(negation(suffices(leaf(holds)))).verdict, refuted);
  EXPECT_EQ(judged(negation(suffices(leaf(fails)))).verdict, undecided);
  EXPECT_EQ(judged(all({leaf(fails), suffices(leaf(fails))})).verdict, refuted);
  EXPECT_EQ(judged(all({leaf(holds), suffices(leaf(fails))})).verdict, undecided);
  EXPECT_EQ(judged(any({leaf(fails), suffices(leaf(fails))})).verdict, undecided);
  EXPECT_NE(judged(suffices(leaf(fails))).reason, "");
}

TEST(Judge, says_why_it_does_not_decide) {
  EXPECT_EQ(judged(all({leaf(holds), negation(leaf(open))})).reason, "effort: no more");
  EXPECT_EQ(judged(leaf(holds)).reason, "");
}

TEST(Judge, decides_nothing_without_its_guards) {
  EXPECT_EQ(judged(leaf(holds), {holds}).verdict, Verdict::proven);
  for (const int goal : {holds, fails}) {
    EXPECT_EQ(judged(leaf(goal), {holds, open}).verdict, Verdict::undecided);
    EXPECT_EQ(judged(leaf(goal), {holds, fails}).verdict, Verdict::undecided);
  }
  EXPECT_EQ(judged(leaf(fails), {open}).reason, "effort: no more");
  EXPECT_EQ(judged(leaf(holds), {fails}).reason.find("degenerate"), 0u);
}

TEST(Judge, gives_a_finding_for_each_obligation) {
  const Judgement judgement = judged(leaf(holds));
  ASSERT_EQ(judgement.findings.size(), 3u);
  EXPECT_EQ(judgement.findings[1].kind, Kind::fails);
}

TEST(Judge, leaves_everything_open_where_a_number_is_not_accepted) {
  Case c;
  c.claim(Zero{c.number(0)});
  c.evidence_begins();
  c.root("r", c.number(2), "-2", "2");
  c.proof(Computation{});
  EXPECT_EQ(c.judged().verdict, Verdict::undecided);
  EXPECT_NE(c.judged().reason.find("degenerate"), std::string::npos);
}

TEST(Judge, rejects_indices_that_point_nowhere) {
  const auto reason = [](auto change) {
    Case c;
    const Term nil = c.number(0);
    c.sum({nil, nil});
    c.claim(Zero{nil});
    c.proof(Computation{});
    change(c);
    const Judgement judgement = c.judged();
    EXPECT_EQ(judgement.verdict == Verdict::proven, judgement.reason.empty());
    return judgement.reason.substr(0, 10);
  };
  EXPECT_EQ(reason([](Case&) {}), "");
  EXPECT_EQ(reason([](Case& c) { c.statement.nodes[1].operands[0] = 1; }), "malformed:");
  EXPECT_EQ(reason([](Case& c) { c.statement.nodes[1].operands[0] = -1; }), "malformed:");
  EXPECT_EQ(reason([](Case& c) { c.statement.nodes[0].text = "2/4x"; }), "malformed:");
  EXPECT_EQ(reason([](Case& c) { c.statement.nodes[0].text = "010"; }), "malformed:");
  EXPECT_EQ(reason([](Case& c) { c.statement.nodes[0].text = "1/0"; }), "malformed:");
  EXPECT_EQ(reason([](Case& c) { c.claim(Zero{2}); }), "malformed:");
  EXPECT_EQ(reason([](Case& c) { c.claim(Zero{-1}); }), "malformed:");
  EXPECT_EQ(reason([](Case& c) { c.statement.goal.obligation = 1; }), "malformed:");
  EXPECT_EQ(reason([](Case& c) { c.statement.goal.obligation = -1; }), "malformed:");
  EXPECT_EQ(reason([](Case& c) { c.statement.guards = {1}; }), "malformed:");
  EXPECT_EQ(reason([](Case& c) { c.evidence.proofs.clear(); }), "malformed:");
  EXPECT_EQ(reason([](Case& c) { c.proof(pieces({split(0, {2})})); }), "malformed:");
  EXPECT_EQ(reason([](Case& c) {
              c.proof(pieces({{Step::Kind::plain, -1, {}}}));
            }),
            "malformed:");
  EXPECT_EQ(reason([](Case& c) {
              c.statement.generators = {{"r", 2, "0", "1"}};
            }),
            "malformed:");
}

TEST(Judge, does_not_let_the_statement_see_nodes_of_the_evidence) {
  Case c;
  c.number(1);
  c.claim(Zero{1});
  c.evidence_begins();
  c.number(0);
  c.proof(Computation{});
  EXPECT_EQ(c.judged().reason.find("malformed"), 0u);
}

TEST(Judge, rejects_a_goal_that_is_nested_too_deeply) {
  Goal goal = leaf(holds);
  for (int i = 0; i < 198; ++i) goal = negation(std::move(goal));
  EXPECT_EQ(judged(goal).verdict, Verdict::proven);
  for (int i = 0; i < 2; ++i) goal = negation(std::move(goal));
  EXPECT_EQ(judged(goal).reason.find("malformed"), 0u);
}

// Whatever is written, the judge answers soon.

TEST(Judge, gives_up_where_the_effort_is_spent) {
  Case c;
  const Term x = c.symbol("x");
  c.claim(Zero{c.power(c.sum({x, c.number(1)}), 200)});
  c.proof(Computation{});
  EXPECT_EQ(c.judged(1000).reason, "effort");
  EXPECT_EQ(c.judged(0).reason, "effort");
  EXPECT_EQ(c.judged(-5).reason, "effort");
  EXPECT_EQ(c.judged().verdict, Verdict::refuted);
}

TEST(Judge, gives_up_on_values_that_are_too_large) {
  for (const int exponent : {40'000, 1'000'000'000, 2'147'483'647}) {
    Case c;
    c.claim(Zero{c.power(c.symbol("x"), exponent)});
    c.proof(Computation{});
    EXPECT_EQ(c.judged().reason, "effort");
  }
  for (const int exponent : {1'000'000, 2'147'483'647}) {
    Case c;
    c.claim(Zero{c.power(c.number(3), exponent)});
    c.proof(Computation{});
    EXPECT_EQ(c.judged().reason, "effort");
  }
}

TEST(Judge, gives_up_on_values_that_grow_at_every_step) {
  Case c;
  Term term = c.sum({c.symbol("x"), c.symbol("y"), c.symbol("z"), c.number("1/3")});
  for (int i = 0; i < 100; ++i) term = c.product({term, term});
  c.claim(Zero{term});
  c.proof(Computation{});
  EXPECT_EQ(c.judged(50'000'000).reason, "effort");
  Case d;
  Term number = d.number("1/3");
  for (int i = 0; i < 100; ++i) number = d.product({number, number});
  d.claim(Zero{number});
  d.proof(Computation{});
  EXPECT_EQ(d.judged(50'000'000).reason, "effort");
}

TEST(Judge, does_not_recurse_along_the_nodes) {
  Case c;
  Term term = c.symbol("x");
  for (int i = 0; i < 100'000; ++i) term = c.sum({term});
  c.claim(Zero{c.difference(term, 0)});
  c.proof(Computation{});
  EXPECT_EQ(c.judged().verdict, Verdict::proven);
}

TEST(Judge, does_not_recurse_along_a_tree) {
  Case c;
  const Term one = c.number(1);
  c.claim(Sign{c.sum({c.symbol("x"), one}), Relation::positive, {{c.segment("x")}, {}}});
  const int depth = 3000;
  Subdivision steps;
  for (int i = 0; i < depth; ++i) steps.push_back(split(0, {one, one}));
  for (int i = 0; i <= depth; ++i) steps.push_back(plain());
  c.proof(pieces(steps));
  EXPECT_EQ(c.judged().verdict, Verdict::proven);
}

TEST(Judge, gives_up_on_a_simplex_with_many_corners) {
  Case c;
  Simplex simplex;
  const Term one = c.number(1);
  const Term nil = c.number(0);
  const int dimension = 30;
  for (int i = 0; i <= dimension; ++i) {
    if (i > 0) simplex.variables.push_back("x" + std::to_string(i));
    simplex.corners.emplace_back(dimension + 1, nil);
    simplex.corners.back()[0] = one;
    simplex.corners.back()[i] = one;
  }
  simplex.open.assign(dimension + 1, false);
  c.claim(Sign{one, Relation::positive, {{simplex}, {}}});
  c.proof(pieces({plain()}));
  EXPECT_NE(c.judged().reason.find("many corners"), std::string::npos);
}

TEST(Judge, gives_up_on_a_box_of_many_factors) {
  Case c;
  Domain domain;
  std::vector<Term> product;
  for (int i = 0; i < 60; ++i) {
    domain.factors.push_back(c.segment("x" + std::to_string(i)));
    product.push_back(c.symbol("x" + std::to_string(i)));
  }
  product.push_back(c.number(1));
  c.claim(Sign{c.sum(product), Relation::positive, domain});
  c.proof(pieces({plain()}));
  EXPECT_EQ(c.judged(20'000'000).reason, "effort");
}

TEST(Judge, a_polynomial_of_degree_16_over_a_number_field_takes_200_pieces_in_a_moment) {
  Case c;
  const Term u = c.symbol("u");
  const Term v = c.symbol("v");
  const Term root = c.root("sqrt(5)", c.number(5), "2", "3");
  const Term one = c.number(1);
  const Term nil = c.number(0);
  const Term base = c.sum({c.product({root, c.power(u, 2)}), c.scaled(3, c.product({u, v})),
                           c.product({c.sum({root, one}), v}), one});
  c.claim(Sign{c.power(base, 8), Relation::positive, {{c.triangle()}, {}}});
  Subdivision steps;
  const std::vector<std::vector<Term>> edges = {
      {one, one, nil}, {nil, one, one}, {one, nil, one}};
  for (int i = 0; i < 200; ++i) {
    steps.push_back(split(0, edges[i % 3]));
    steps.push_back(plain());
  }
  steps.push_back(plain());
  c.proof(pieces(steps));
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(c.judged().reason, "");
  const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
  EXPECT_LT(time.count(), 60);  // far above what it takes, also with sanitizers
}

}  // namespace
}  // namespace seam::check::test
