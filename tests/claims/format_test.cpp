// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "random_tree.h"
#include "tree.h"

namespace seam::claims {
namespace {

std::string formatted(const std::string& bytes) {
  const Parsed parsed = parse(source(bytes));
  EXPECT_EQ(messages(parsed), "");
  return format(parsed.file);
}

// As an expression alone.
std::string canonical(const std::string& bytes) {
  return format(parse_expression(source(bytes)).expression);
}

TEST(Format, of_random_files_reads_back_as_the_same_trees) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    const File file = RandomTree(seed).file(10);
    const std::string text = format(file);
    const Parsed parsed = parse(source(text));
    ASSERT_EQ(messages(parsed), "") << "seed " << seed;
    ASSERT_TRUE(same(file, parsed.file)) << "seed " << seed << "\n" << text;
    ASSERT_EQ(format(parsed.file), text) << "seed " << seed;
  }
}

TEST(Format, of_random_expressions_reads_back_as_the_same_trees) {
  for (unsigned seed = 0; seed < 600; ++seed) {
    const Expression e = RandomTree(seed).statement(6);
    const std::string text = format(e);
    const ParsedExpression parsed = parse_expression(source(text));
    ASSERT_TRUE(parsed.errors.empty()) << text << "\n" << text::render(parsed.errors.front());
    ASSERT_TRUE(same(e, parsed.expression)) << "seed " << seed << "\n" << text;
  }
}

TEST(Format, of_every_form_is_canonical) {
  std::ifstream in("tests/claims/grammar.seam");
  std::stringstream bytes;
  bytes << in.rdbuf();
  const std::string once = formatted(bytes.str());
  EXPECT_EQ(formatted(once), once);
  EXPECT_TRUE(same(parse(source(bytes.str())).file, parse(source(once)).file));
}

TEST(Format, writes_only_the_parentheses_that_are_needed) {
  EXPECT_EQ(canonical("((a + (b*c)) - (d - e))"), "a + b*c - (d - e)");
  EXPECT_EQ(canonical("(-x)^2 + -(x^2) + (2^3)^4 + 2^(3^4)"),
            "(-x)^2 + -x^2 + (2^3)^4 + 2^3^4");
  EXPECT_EQ(canonical("(a*b)/(c*d)"), "a*b/(c*d)");
  EXPECT_EQ(canonical("((f)(x))(y)"), "f(x)(y)");
  EXPECT_EQ(canonical("(a = b) and (c or d)"), "a = b and (c or d)");
  EXPECT_EQ(canonical("not (a and b)"), "not (a and b)");
  EXPECT_EQ(canonical("(a implies b) implies c"), "(a implies b) implies c");
  EXPECT_EQ(canonical("f((x = 1), x = 1)"), "f((x = 1), x = 1)");
}

TEST(Format, spells_signs_and_greek_letters_out_and_keeps_numbers) {
  EXPECT_EQ(canonical("√5·γ ≤ 0.50"), "sqrt(5)*gamma <= 0.50");
  EXPECT_EQ(canonical("∀ u ∈ [0,1]: ¬ a ∧ b"), "for u in [0, 1]: not a and b");
}

TEST(Format, encloses_quantifiers_inside_statements) {
  EXPECT_EQ(canonical("a and for all u: b and c"), "a and (for all u: b and c)");
  EXPECT_EQ(canonical("for all u: for some v: a"), "for all u: for some v: a");
}

TEST(Format, puts_each_row_of_a_net_on_its_line) {
  EXPECT_EQ(formatted("let p = triangle_patch [ a, b; c; ]"),
            "let p = triangle_patch [\n"
            "    a, b;\n"
            "    c ]\n");
}

TEST(Format, breaks_long_lines_at_the_outermost_places) {
  EXPECT_EQ(
      formatted(
          "let area = first_long_name(alpha, beta, gamma)*second_long_name(delta, epsilon)"
          " + third_long_name(zeta, eta) - fourth_long_name(theta, iota)"),
      "let area = first_long_name(alpha, beta, gamma)*second_long_name(delta, epsilon)\n"
      "    + third_long_name(zeta, eta) - fourth_long_name(theta, iota)\n");
}

TEST(Format, of_a_claim_has_a_line_for_the_statement_and_each_clause) {
  EXPECT_EQ(
      formatted(
          "claim a at \"§1\" \"t\": x = 1 by f 2 expect refuted using b,c corrected: x = 2"),
      "claim a \"t\" at \"§1\":\n"
      "    x = 1\n"
      "    corrected: x = 2\n"
      "    expect refuted\n"
      "    using b, c\n"
      "    by f 2\n");
}

TEST(Format, of_a_table_has_columns) {
  EXPECT_EQ(
      formatted("table t for k in 1..2: \"α\" f(k) ~ 1, 2 \"long\" longer(k) ~ 3, 4 truncated"),
      "table t for k in 1..2:\n"
      "    \"α\"    f(k)      ~ 1, 2\n"
      "    \"long\" longer(k) ~ 3, 4 truncated\n");
}

TEST(Format, keeps_definitions_together_and_comments_above_their_item) {
  EXPECT_EQ(formatted("#first\nlet a = 1 # one\nlet b = 2\n\n\nclaim c: a = b # why\n#end"),
            "# first\n"
            "# one\n"
            "let a = 1\n"
            "let b = 2\n"
            "\n"
            "# why\n"
            "claim c:\n"
            "    a = b\n"
            "\n"
            "# end\n");
}

TEST(Format, of_nothing_is_nothing) {
  EXPECT_EQ(formatted(""), "");
  EXPECT_EQ(formatted("# only"), "# only\n");
}

}  // namespace
}  // namespace seam::claims
