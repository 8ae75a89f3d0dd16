// SPDX-License-Identifier: GPL-3.0-or-later
#include "drafting.h"

namespace seam::prove {
namespace {

using certificate::Constraint;
using certificate::Relation;
using certificate::Sign;
using certificate::Verdict;
using certificate::Zero;
using enum certificate::Relation;
using enum certificate::Verdict;

struct FunctionProofs : testing::Test {
  Draft d;
  T c = d.symbol("c"), x = d.symbol("x"), y = d.symbol("y");
  T root(const std::string& name, T radicand, int degree = 2) {
    d.statement.functions.push_back({name, radicand.term, degree});
    return d.symbol(name);
  }
  Verdict inside(T f, Relation relation) {  // for c in (0, 1)
    return d.verdict(Sign{f.term, relation, {{d.segment("c", "0", "1", true, true)}, {}}});
  }
  Verdict up_to_ends(T f, Relation relation) {  // for c in [0, 1]
    return d.verdict(Sign{f.term, relation, {{d.segment("c", "0", "1")}, {}}});
  }
  Verdict where(T f, Relation relation, std::vector<Constraint> conditions) {
    return d.verdict(
        Sign{f.term,
             relation,
             {{d.segment("x", "-2", "2"), d.segment("y", "-2", "2")}, std::move(conditions)}});
  }
};

TEST_F(FunctionProofs, an_identity_of_functions) {
  const T r = root("r", 1 - (c ^ 2));
  const T s = root("s", 1 + r);
  EXPECT_EQ(d.verdict(Zero{((r ^ 4) - ((1 - (c ^ 2)) ^ 2)).term}), proven);
  EXPECT_EQ(d.verdict(Zero{(((s ^ 2) - 1) * r - 1 + (c ^ 2)).term}), proven);
  EXPECT_EQ(d.verdict(Zero{(r + c - 1).term}), refuted);
  EXPECT_EQ(d.verdict(Zero{(s - r).term}), refuted);
}

TEST_F(FunctionProofs, a_root_has_the_sign_of_its_radicand) {
  const T r = root("r", 1 - (c ^ 2));
  EXPECT_EQ(inside(r, positive), proven);
  EXPECT_EQ(inside(r, nonzero), proven);
  EXPECT_EQ(up_to_ends(r, nonnegative), proven);
  EXPECT_EQ(up_to_ends(r, positive), refuted);
  EXPECT_EQ(up_to_ends(r, nonzero), refuted);
  EXPECT_EQ(inside(r, negative), refuted);
}

TEST_F(FunctionProofs, a_root_is_compared_with_a_polynomial) {
  const T r = root("r", 1 - (c ^ 2));
  EXPECT_EQ(inside(1 - r, positive), proven);
  EXPECT_EQ(up_to_ends(1 - r, nonnegative), proven);
  EXPECT_EQ(up_to_ends(1 - r, positive), refuted);
  EXPECT_EQ(inside(r - 1, negative), proven);
  EXPECT_EQ(inside(r + c - 1, positive), proven);
  EXPECT_EQ(up_to_ends(r + c - 1, nonnegative), proven);
  EXPECT_EQ(inside(r - c, nonnegative), refuted);
  EXPECT_EQ(up_to_ends(3 * c + 4 * r - 5, nonpositive), proven);  // touches at 3/5
  EXPECT_EQ(up_to_ends(3 * c + 4 * r - 5, negative), refuted);
  EXPECT_EQ(up_to_ends(100 * c + 100 * r - 141, negative), refuted);  // sqrt(2) is more
  EXPECT_EQ(up_to_ends(100 * c + 100 * r - 142, negative), proven);
}

TEST_F(FunctionProofs, a_value_other_than_zero) {
  const T r = root("r", 1 - (c ^ 2));
  EXPECT_EQ(inside(1 - r, nonzero), proven);
  EXPECT_EQ(inside(r + c - 1, nonzero), proven);
  EXPECT_EQ(inside(5 * r - 4, nonzero), refuted);
}

TEST_F(FunctionProofs, two_roots) {
  const T r = root("r", 1 - (c ^ 2)), s = root("s", 4 - (c ^ 2));
  EXPECT_EQ(up_to_ends(s - r, positive), proven);
  EXPECT_EQ(up_to_ends(s - r - 1, nonnegative), proven);  // 0 at c = 0
  EXPECT_EQ(up_to_ends(s - 2 * r, nonnegative), proven);
  EXPECT_EQ(up_to_ends(s - 2 * r, positive), refuted);
  EXPECT_EQ(up_to_ends(s - r - 2, nonnegative), refuted);
}

TEST_F(FunctionProofs, a_root_in_a_root) {
  const T r = root("r", 1 - (c ^ 2));
  const T s = root("s", 1 + r);
  EXPECT_EQ(up_to_ends(s - 1, nonnegative), proven);
  EXPECT_EQ(inside(s - 1, positive), proven);
  EXPECT_EQ(up_to_ends(2 - (s ^ 2), nonnegative), proven);
  EXPECT_EQ(up_to_ends((s ^ 2) - 2, nonnegative), refuted);
}

TEST_F(FunctionProofs, factors_of_no_constant_sign) {
  const T r = root("r", 1 + (c ^ 2));
  // (2 c - 1) r + (2 c - 1)^2 * 4 + 1: neither part has one sign
  EXPECT_EQ(up_to_ends((2 * c - 1) * r + 2, positive), proven);
  EXPECT_EQ(up_to_ends((2 * c - 1) * r + (2 * c - 1), nonnegative), refuted);
  EXPECT_EQ(up_to_ends(((2 * c - 1) ^ 2) * r + ((2 * c - 1) ^ 2), nonnegative), proven);
  EXPECT_EQ(up_to_ends(((2 * c - 1) ^ 3) * r + ((2 * c - 1) ^ 4), nonnegative), refuted);
}

TEST_F(FunctionProofs, a_sign_that_changes_with_that_of_the_variable) {
  // |x| as sqrt(x^2): |x| + x >= 0, |x| - x >= 0, |x| |y| - x y >= 0.
  const T a = root("a", x ^ 2), b = root("b", y ^ 2);
  EXPECT_EQ(where(a + x, nonnegative, {}), proven);
  EXPECT_EQ(where(a - x, nonnegative, {}), proven);
  EXPECT_EQ(where(a - x, positive, {}), refuted);
  EXPECT_EQ(where(a * b - x * y, nonnegative, {}), proven);
  EXPECT_EQ(where(a - x, nonnegative, {{x.term, nonnegative}}), proven);
  EXPECT_EQ(where(a - x, nonpositive, {{x.term, nonnegative}}), proven);
  EXPECT_EQ(where(-2 * x, nonpositive, {{x.term, nonnegative}}), proven);
  EXPECT_EQ(where(a - x, zero, {{x.term, nonnegative}}), proven);
  EXPECT_EQ(where(a - x, zero, {}), refuted);
}

TEST_F(FunctionProofs, the_triangle_inequality) {
  const T sum = root("sum", (x + y) ^ 2), a = root("a", x ^ 2), b = root("b", y ^ 2);
  EXPECT_EQ(where(a + b - sum, nonnegative, {}), proven);
  EXPECT_EQ(where(sum - a - b, nonpositive, {}), proven);
  EXPECT_EQ(where(sum - a - b, negative, {}), refuted);
  EXPECT_EQ(where(2 * a + 2 * b - 3 * sum, nonnegative, {}), refuted);
}

TEST_F(FunctionProofs, functions_of_one_statement_may_differ_by_obligation) {
  const T r = root("r", 1 - (c ^ 2)), s = root("s", 2 - (c ^ 2));
  d.statement.obligations = {Sign{r.term, nonnegative, {{d.segment("c", "0", "1")}, {}}}};
  auto other = std::get<Sign>(d.statement.obligations[0]);
  other.formula = s.term;
  d.statement.obligations.push_back(other);
  d.statement.goal = {certificate::Goal::Kind::all,
                      {{certificate::Goal::Kind::obligation, {}, 0},
                       {certificate::Goal::Kind::obligation, {}, 1}},
                      -1};
  EXPECT_EQ(check::judge(d.statement, prove(d.statement)).verdict, proven);
}

TEST_F(FunctionProofs, an_equation_by_the_conjugate) {
  const T r = root("r", ((c ^ 2) + 1) ^ 2);
  EXPECT_EQ(up_to_ends(r - (c ^ 2) - 1, zero), proven);
  EXPECT_EQ(up_to_ends(r - (c ^ 2) - 2, zero), refuted);
  EXPECT_EQ(up_to_ends(r + (c ^ 2) + 1, zero), refuted);
}

TEST_F(FunctionProofs, a_root_of_degree_3) {
  const T r = root("r", 1 + c, 3);
  EXPECT_EQ(up_to_ends(r, positive), proven);
  EXPECT_EQ(up_to_ends((r ^ 3) - c, positive), proven);
  EXPECT_EQ(up_to_ends(2 - r, positive), proven);
  EXPECT_EQ(up_to_ends(r - 1, positive), refuted);
}

TEST_F(FunctionProofs, where_the_radicand_is_negative_nothing_is_claimed) {
  const T r = root("r", c - (d.number("1/2")));
  EXPECT_EQ(up_to_ends(4 * c - 1 + r, positive), proven);
  EXPECT_EQ(up_to_ends(4 * c - 1, positive), refuted);
}

TEST_F(FunctionProofs, equations_as_conditions) {
  const T circle = (x ^ 2) + (y ^ 2) - 1;
  const std::vector<Constraint> on_circle = {{circle.term, zero}};
  EXPECT_EQ(where((x ^ 4) - (y ^ 4) - (x ^ 2) + (y ^ 2), zero, on_circle), proven);
  EXPECT_EQ(where((x ^ 4) - (y ^ 4) - (x ^ 2) - (y ^ 2), zero, on_circle), refuted);
  EXPECT_EQ(where(1 - (x ^ 2), nonnegative, on_circle), proven);
  EXPECT_EQ(where(x + y - 1, nonpositive, on_circle), refuted);
  EXPECT_EQ(where(2 * x + 2 * y - 3, negative, on_circle), proven);
  EXPECT_EQ(where((x ^ 2) + 2 * (y ^ 2) - 1, nonnegative, on_circle), proven);
}

TEST_F(FunctionProofs, equations_and_functions) {
  const T r = root("r", (x ^ 2) + (y ^ 2));
  const std::vector<Constraint> on_line = {{(x + y - 1).term, zero}};
  EXPECT_EQ(where((r ^ 2) - 1 + 2 * x * y, zero, on_line), proven);
  EXPECT_EQ(where(r - 1, nonpositive, on_line), refuted);
  EXPECT_EQ(where(3 * r - 2, positive, on_line), proven);
  const std::vector<Constraint> on_circle = {{((x ^ 2) + (y ^ 2) - 1).term, zero}};
  EXPECT_EQ(where(r - 1, zero, on_circle), proven);
}

}  // namespace
}  // namespace seam::prove
