// SPDX-License-Identifier: GPL-3.0-or-later
#include "drafting.h"

namespace seam::prove {
namespace {

using certificate::OnlySolutions;
using certificate::Relation;
using certificate::Verdict;

struct Eliminations : testing::Test {
  Draft d;
  T c = d.symbol("c"), x = d.symbol("x"), y = d.symbol("y"), u = d.symbol("u");
  T one = d.number("1");

  Verdict solve(const std::vector<T>& system, std::vector<std::vector<T>> numerators,
                std::vector<certificate::Constraint> where = {}) {
    OnlySolutions stated{
        {}, {"x", "y"}, {"u"}, {{d.segment("c", "0", "1", true, true)}, {}}, {}};
    stated.domain.where = std::move(where);
    for (const T f : system) stated.system.push_back(f.term);
    for (const auto& solution : numerators) {
      auto& tuple = stated.solutions.emplace_back();
      for (const T f : solution) {
        tuple.numerators.push_back(f.term);
        tuple.denominators.push_back(one.term);
      }
    }
    return d.verdict(stated);
  }
};

TEST_F(Eliminations, a_linear_system) {
  EXPECT_EQ(solve({x + y - 1, x - y - c}, {}), Verdict::refuted);
  EXPECT_EQ(solve({2 * x - c, x - y}, {{d.number("1/2") * c, d.number("1/2") * c}}),
            Verdict::proven);
}

TEST_F(Eliminations, a_coefficient_that_may_vanish_makes_two_cases) {
  EXPECT_EQ(solve({x * y - 1, (x - c) * y}, {}), Verdict::refuted);
  EXPECT_EQ(solve({x * y - c, (x - 1) * y}, {{one, c}}), Verdict::proven);
}

TEST_F(Eliminations, a_circle_and_a_line_that_misses_it) {
  EXPECT_EQ(solve({(x ^ 2) + (y ^ 2) - c, x + y - 3}, {}), Verdict::proven);
}

TEST_F(Eliminations, an_irrational_point_refutes) {
  EXPECT_EQ(solve({(x ^ 2) - 2 * c, x - y}, {}), Verdict::refuted);
}

TEST_F(Eliminations, a_parameter_with_one_special_value) {
  EXPECT_EQ(solve({(3 * c - 1) * x, y - 1}, {{d.number("0"), one}}), Verdict::refuted);
  EXPECT_EQ(solve({(3 * c - 4) * x, y - 1}, {{d.number("0"), one}}), Verdict::proven);
}

TEST_F(Eliminations, a_free_unknown_refutes) {
  EXPECT_EQ(solve({x * y}, {{d.number("0"), d.number("0")}}), Verdict::refuted);
}

TEST_F(Eliminations, no_equation_at_all) {
  EXPECT_EQ(solve({}, {{d.number("0"), d.number("0")}}), Verdict::refuted);
}

TEST_F(Eliminations, a_condition_in_factors_excludes_each_of_them) {
  const T product = x * (x - 1) * y;
  EXPECT_EQ(
      solve({x * (x - 1) * (x - c), y - x}, {{c, c}}, {{product.term, Relation::nonzero}}),
      Verdict::proven);
  EXPECT_EQ(
      solve({x * (x - 2) * (x - c), y - x}, {{c, c}}, {{product.term, Relation::nonzero}}),
      Verdict::refuted);
}

TEST_F(Eliminations, an_identity_in_a_variable_gives_a_system) {
  EXPECT_EQ(solve({(x - c) * (u ^ 2) + (y * x - 1) * u + (x * (y - 1) - 1 + c)}, {}),
            Verdict::refuted);
  EXPECT_EQ(solve({(x - 1) * (u ^ 2) + (y * x - c) * u}, {{one, c}}), Verdict::proven);
}

TEST_F(Eliminations, a_search_that_is_given_no_effort_says_so) {
  OnlySolutions stated{{((x ^ 2) + y).term}, {"x", "y"}, {}, {}, {}};
  EXPECT_EQ(d.verdict(stated, {0}), Verdict::undecided);
  EXPECT_NE(d.last.find("effort"), std::string::npos) << d.last;
}

}  // namespace
}  // namespace seam::prove
