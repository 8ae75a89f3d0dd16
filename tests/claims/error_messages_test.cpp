// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tree.h"

namespace seam::claims {
namespace {

std::string messages(const std::string& bytes) {
  return messages(parse(source(bytes)));
}

TEST(ErrorMessages, where_an_operand_is_missing) {
  EXPECT_EQ(messages("let a = 1 +\n"
                     "let b = 2\n"),
            "a.seam:1:12: error: expected an expression after '+'\n"
            "  1 | let a = 1 +\n"
            "    |            ^\n");
}

TEST(ErrorMessages, where_an_operand_is_missing_on_its_line) {
  EXPECT_EQ(messages("let a = (1 + ) * 2\n"),
            "a.seam:1:14: error: expected an expression after '+'\n"
            "  1 | let a = (1 + ) * 2\n"
            "    |              ^\n");
}

TEST(ErrorMessages, where_a_product_has_no_operator) {
  EXPECT_EQ(messages("let a = 2x\n"),
            "a.seam:1:10: error: expected an operator between '2' and 'x'\n"
            "  1 | let a = 2x\n"
            "    |          ^\n"
            "    = there is no invisible product: write '*'\n");
}

TEST(ErrorMessages, where_a_product_has_no_operator_and_a_blank) {
  EXPECT_EQ(messages("let a = 2 x\n"),
            "a.seam:1:11: error: expected an operator between '2' and 'x'\n"
            "  1 | let a = 2 x\n"
            "    |           ^\n"
            "    = there is no invisible product: write '*'\n");
}

TEST(ErrorMessages, where_a_product_of_parentheses_has_no_operator) {
  EXPECT_EQ(messages("let a = 2(x + 1)\n"),
            "a.seam:1:10: error: expected an operator between '2' and '('\n"
            "  1 | let a = 2(x + 1)\n"
            "    |          ^\n"
            "    = there is no invisible product: write '*'\n");
}

TEST(ErrorMessages, where_an_operator_is_misspelled) {
  EXPECT_EQ(messages("claim a: x = 1 adn y = 2\n"),
            "a.seam:1:16: error: expected an operator before 'adn'\n"
            "  1 | claim a: x = 1 adn y = 2\n"
            "    |                ^~~\n"
            "    = did you mean 'and'?\n");
}

TEST(ErrorMessages, where_a_parenthesis_is_not_closed) {
  EXPECT_EQ(messages("let a = f(x, (y + 1)\n"
                     "let b = 2\n"),
            "a.seam:1:21: error: expected ',' or ')' after ')'\n"
            "  1 | let a = f(x, (y + 1)\n"
            "    |                     ^\n"
            "    = '(' was opened at 1:10\n");
}

TEST(ErrorMessages, where_a_parenthesis_closes_nothing) {
  EXPECT_EQ(messages("let a = f(x))\n"),
            "a.seam:1:13: error: ')' closes nothing\n"
            "  1 | let a = f(x))\n"
            "    |             ^\n");
}

TEST(ErrorMessages, where_a_call_is_closed_too_early) {
  EXPECT_EQ(messages("let a = f(x,)\n"),
            "a.seam:1:13: error: expected an expression after ','\n"
            "  1 | let a = f(x,)\n"
            "    |             ^\n");
}

TEST(ErrorMessages, where_parentheses_are_empty) {
  EXPECT_EQ(messages("let a = ()\n"),
            "a.seam:1:10: error: expected an expression after '('\n"
            "  1 | let a = ()\n"
            "    |          ^\n");
}

TEST(ErrorMessages, where_a_half_open_interval_is_used_as_a_value) {
  EXPECT_EQ(messages("param k in (0, 1] + 1\n"),
            "a.seam:1:12: error: a half-open interval is a set and no value\n"
            "  1 | param k in (0, 1] + 1\n"
            "    |            ^~~~~~\n");
}

TEST(ErrorMessages, where_a_half_open_interval_stands_elsewhere) {
  EXPECT_EQ(messages("let a = [0, 1)\n"),
            "a.seam:1:14: error: expected ',', ';' or ']' after '1'\n"
            "  1 | let a = [0, 1)\n"
            "    |              ^\n"
            "    = '[' was opened at 1:9\n");
}

TEST(ErrorMessages, where_a_name_is_reserved) {
  EXPECT_EQ(messages("let curve = 1\n"),
            "a.seam:1:5: error: expected a name after 'let'\n"
            "  1 | let curve = 1\n"
            "    |     ^~~~~\n"
            "    = 'curve' is a word of the language\n");
}

TEST(ErrorMessages, where_equality_is_doubled) {
  EXPECT_EQ(messages("claim a: x == 1\n"),
            "a.seam:1:12: error: unexpected '='\n"
            "  1 | claim a: x == 1\n"
            "    |            ^\n"
            "    = write '='\n");
}

TEST(ErrorMessages, where_a_minus_sign_is_not_ascii) {
  EXPECT_EQ(messages("let a = 1 − 2\n"),
            "a.seam:1:11: error: unexpected '−'\n"
            "  1 | let a = 1 − 2\n"
            "    |           ^\n"
            "    = write '-'\n");
}

TEST(ErrorMessages, where_a_power_is_a_superscript) {
  EXPECT_EQ(messages("let a = x² + 1\n"),
            "a.seam:1:10: error: unexpected '²'\n"
            "  1 | let a = x² + 1\n"
            "    |          ^\n"
            "    = write '^2'\n");
}

TEST(ErrorMessages, where_a_decimal_has_no_digits) {
  EXPECT_EQ(messages("let a = 1. + 2\n"),
            "a.seam:1:11: error: expected a digit after the decimal point\n"
            "  1 | let a = 1. + 2\n"
            "    |           ^\n");
}

TEST(ErrorMessages, where_a_decimal_begins_with_its_point) {
  EXPECT_EQ(messages("let a = .5\n"),
            "a.seam:1:9: error: expected an expression after '='\n"
            "  1 | let a = .5\n"
            "    |         ^\n"
            "    = write 0.5, with a digit before the point\n");
}

TEST(ErrorMessages, where_a_quantifier_has_no_set) {
  EXPECT_EQ(messages("claim a: for u: u = u\n"),
            "a.seam:1:15: error: expected 'in' and a set after 'u'\n"
            "  1 | claim a: for u: u = u\n"
            "    |               ^\n"
            "    = for every real number write 'for all u'\n");
}

TEST(ErrorMessages, where_only_the_last_name_has_a_set) {
  EXPECT_EQ(messages("claim a: for all u, v in [0, 1]: u = v\n"),
            "a.seam:1:23: error: only the last of these names has a set\n"
            "  1 | claim a: for all u, v in [0, 1]: u = v\n"
            "    |                       ^~\n"
            "    = write 'u in S, v in S'\n");
}

TEST(ErrorMessages, where_a_quantifier_stands_behind) {
  EXPECT_EQ(messages("claim a: u = u for u in [0, 1]\n"),
            "a.seam:1:16: error: a quantifier stands in front of its statement\n"
            "  1 | claim a: u = u for u in [0, 1]\n"
            "    |                ^~~\n"
            "    = write 'for u in [0, 1]: S'\n");
}

TEST(ErrorMessages, where_truncated_has_no_decimal) {
  EXPECT_EQ(messages("claim a: x = 1.5 truncated\n"),
            "a.seam:1:18: error: 'truncated' stands only after a printed decimal\n"
            "  1 | claim a: x = 1.5 truncated\n"
            "    |                  ^~~~~~~~~\n"
            "    = as in 'E ~ 1.5849 truncated'\n");
}

TEST(ErrorMessages, where_a_solve_gives_nothing) {
  EXPECT_EQ(messages("claim a: solve x: x = 1\n"),
            "a.seam:1:24: error: expected 'gives' and the solutions after '1'\n"
            "  1 | claim a: solve x: x = 1\n"
            "    |                        ^\n");
}

TEST(ErrorMessages, where_a_weight_stands_in_a_patch_that_is_not_rational) {
  EXPECT_EQ(messages("let p = quad_patch [ P:1, Q; R, S ]\n"),
            "a.seam:1:23: error: a weight stands only in a rational patch\n"
            "  1 | let p = quad_patch [ P:1, Q; R, S ]\n"
            "    |                       ^~\n"
            "    = write 'rational quad_patch'\n");
}

TEST(ErrorMessages, where_a_patch_has_no_net) {
  EXPECT_EQ(messages("let p = quad_patch\n"),
            "a.seam:1:19: error: expected '[', 'from', or a degree and '{' after 'quad_patch'\n"
            "  1 | let p = quad_patch\n"
            "    |                   ^\n");
}

TEST(ErrorMessages, where_a_net_has_an_empty_row) {
  EXPECT_EQ(messages("let p = quad_patch [ P, Q; ; R, S ]\n"),
            "a.seam:1:28: error: expected an expression after ';'\n"
            "  1 | let p = quad_patch [ P, Q; ; R, S ]\n"
            "    |                            ^\n");
}

TEST(ErrorMessages, where_a_matrix_has_one_row) {
  EXPECT_EQ(messages("let m = [1, 2;]\n"),
            "a.seam:1:9: error: a matrix has two rows or more\n"
            "  1 | let m = [1, 2;]\n"
            "    |         ^~~~~~~\n"
            "    = a list is written without ';'\n");
}

TEST(ErrorMessages, where_an_index_is_no_index) {
  EXPECT_EQ(messages("let p = triangle_patch 1 { v0; }\n"),
            "a.seam:1:28: error: expected an index such as '300' after '{'\n"
            "  1 | let p = triangle_patch 1 { v0; }\n"
            "    |                            ^~\n");
}

}  // namespace
}  // namespace seam::claims
