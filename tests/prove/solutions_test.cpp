// SPDX-License-Identifier: GPL-3.0-or-later
#include "drafting.h"

namespace seam::prove {
namespace {

using certificate::Solution;
using certificate::Solutions;
using certificate::Verdict;

struct SolutionProofs : testing::Test {
  Draft d;
  T x = d.symbol("x"), u = d.symbol("u");
  Solution exactly(T value) { return {value.term, "", ""}; }
  Solution exactly(const std::string& text) { return exactly(d.number(text)); }
  Verdict solve(const std::vector<T>& system, certificate::Simplex domain,
                std::vector<Solution> solutions) {
    Solutions stated{{}, "x", {"u"}, std::move(domain), std::move(solutions)};
    for (const T f : system) stated.system.push_back(f.term);
    return d.verdict(stated);
  }
};

TEST_F(SolutionProofs, the_roots_of_a_quadratic) {
  const T f = (x - 1) * (x - 2);
  EXPECT_EQ(solve({f}, d.from_zero("x"), {exactly("1"), exactly("2")}), Verdict::proven);
  EXPECT_EQ(solve({f}, d.from_zero("x"), {exactly("1")}), Verdict::refuted);
  EXPECT_EQ(solve({f}, d.from_zero("x"), {exactly("1"), exactly("2"), exactly("3")}),
            Verdict::refuted);
  EXPECT_EQ(solve({f}, d.segment("x", "0", "2", false, true), {exactly("1")}), Verdict::proven);
  EXPECT_EQ(solve({f}, d.segment("x", "0", "2"), {exactly("1")}), Verdict::refuted);
}

TEST_F(SolutionProofs, an_identity_in_a_variable_gives_a_system) {
  const T f = (x - 3) * (x + 1) * u * u + (x - 3) * (x - 7) * u;
  EXPECT_EQ(solve({f}, d.from_zero("x"), {exactly("3")}), Verdict::proven);
  EXPECT_EQ(solve({f}, d.from_zero("x"), {exactly("7")}), Verdict::refuted);
  EXPECT_EQ(solve({f}, d.from_zero("x"), {}), Verdict::refuted);
}

TEST_F(SolutionProofs, two_equations_without_a_common_root) {
  EXPECT_EQ(solve({x - 1, x - 2}, d.from_zero("x"), {}), Verdict::proven);
}

TEST_F(SolutionProofs, a_multiple_root_counts_once) {
  EXPECT_EQ(solve({((x - 1) ^ 3) * ((x ^ 2) + 1)}, d.from_zero("x"), {exactly("1")}),
            Verdict::proven);
}

TEST_F(SolutionProofs, an_irrational_root) {
  const T s = d.generator("sqrt(2)", (d.symbol("sqrt(2)") ^ 2) - 2, "1", "2");
  EXPECT_EQ(solve({(x ^ 2) - 2}, d.from_zero("x"), {exactly(s)}), Verdict::proven);
  EXPECT_EQ(solve({(x ^ 2) - 3}, d.from_zero("x"), {exactly(s)}), Verdict::refuted);
  EXPECT_EQ(solve({((x ^ 2) - 2) * ((x ^ 2) - 3)}, d.from_zero("x"), {exactly(s)}),
            Verdict::refuted);
}

TEST_F(SolutionProofs, roots_within_intervals) {
  const T f = (x ^ 3) - 3 * x + 1;  // -1.88, 0.347, 1.53
  const auto domain = [&] { return d.segment("x", "-2", "2"); };
  const std::vector<Solution> all = {
      {-1, "-19/10", "-18/10"}, {-1, "3/10", "4/10"}, {-1, "3/2", "8/5"}};
  EXPECT_EQ(solve({f}, domain(), all), Verdict::proven);
  EXPECT_EQ(solve({f}, domain(), {all[0], all[2]}), Verdict::refuted);
  EXPECT_EQ(solve({f}, d.from_zero("x"), {all[1], all[2]}), Verdict::proven);
  EXPECT_EQ(solve({f}, domain(), {all[0], {-1, "1/10", "2/10"}, all[1], all[2]}),
            Verdict::undecided);
}

TEST_F(SolutionProofs, the_whole_line_takes_two_trees) {
  const Solutions stated{
      {((x - 1) * ((x ^ 2) + 1)).term}, "x", {}, {{"x"}, {}, {}}, {exactly("1")}};
  const auto evidence = d.proof(stated);
  const auto* roots = std::get_if<certificate::Roots>(&evidence.proofs[0]);
  ASSERT_TRUE(roots);
  EXPECT_EQ(roots->outside.size(), 2U);
}

TEST_F(SolutionProofs, an_equation_that_always_holds_has_more_solutions) {
  EXPECT_EQ(solve({x - x}, d.segment("x", "0", "1", true, true), {exactly("1/2")}),
            Verdict::refuted);
}

}  // namespace
}  // namespace seam::prove
