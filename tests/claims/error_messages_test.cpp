// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "claims/syntax.h"

namespace seam::claims {
namespace {

std::string messages(const std::string& bytes) {
  std::string all;
  for (const auto& error :
       parse(std::make_shared<text::Source>(text::Source{"a.seam", bytes})).errors)
    all += text::render(error);
  return all;
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

TEST(ErrorMessages, where_a_colon_is_missing) {
  EXPECT_EQ(messages("claim a.b x = 1\n"),
            "a.seam:1:11: error: expected ':' before the statement\n"
            "  1 | claim a.b x = 1\n"
            "    |           ^\n");
}

TEST(ErrorMessages, where_a_colon_that_touches_a_word_belongs_to_the_id) {
  EXPECT_EQ(
      messages("claim a:x = 1\n"),
      "a.seam:1:11: error: expected ':' before the statement\n"
      "  1 | claim a:x = 1\n"
      "    |           ^\n"
      "    = a ':' that touches the next word belongs to the id: put a blank behind it\n");
}

TEST(ErrorMessages, where_a_claim_has_no_statement) {
  EXPECT_EQ(messages("claim a.b:\n"
                     "\n"
                     "let x = 1\n"),
            "a.seam:1:7: error: this claim has no statement\n"
            "  1 | claim a.b:\n"
            "    |       ^~~\n"
            "    = a statement stands after ':'\n");
}

TEST(ErrorMessages, where_a_claim_has_a_clause_and_no_statement) {
  EXPECT_EQ(messages("claim a.b:\n"
                     "    expect refuted\n"),
            "a.seam:1:7: error: this claim has no statement\n"
            "  1 | claim a.b:\n"
            "    |       ^~~\n"
            "    = a statement stands after ':'\n");
}

TEST(ErrorMessages, where_a_clause_is_misspelled) {
  EXPECT_EQ(messages("claim a: x = 1\n"
                     "    corected: x = 2\n"),
            "a.seam:2:5: error: unknown clause 'corected'\n"
            "  2 |     corected: x = 2\n"
            "    |     ^~~~~~~~\n"
            "    = did you mean 'corrected'?\n");
}

TEST(ErrorMessages, where_a_clause_is_unknown) {
  EXPECT_EQ(messages("claim a: x = 1\n"
                     "    because: x = 2\n"),
            "a.seam:2:5: error: unknown clause 'because'\n"
            "  2 |     because: x = 2\n"
            "    |     ^~~~~~~\n");
}

TEST(ErrorMessages, where_an_item_is_misspelled) {
  EXPECT_EQ(messages("clam a: x = 1\n"),
            "a.seam:1:1: error: unknown item 'clam'\n"
            "  1 | clam a: x = 1\n"
            "    | ^~~~\n"
            "    = did you mean 'claim'?\n");
}

TEST(ErrorMessages, where_an_item_is_misspelled_after_a_definition) {
  EXPECT_EQ(messages("let a = 1\n"
                     "lte b = 2\n"),
            "a.seam:2:1: error: unknown item 'lte'\n"
            "  2 | lte b = 2\n"
            "    | ^~~\n"
            "    = did you mean 'let'?\n");
}

TEST(ErrorMessages, where_something_else_stands_where_an_item_should) {
  EXPECT_EQ(messages("(1)\n"),
            "a.seam:1:1: error: expected an item, such as 'let' or 'claim'\n"
            "  1 | (1)\n"
            "    | ^\n");
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

TEST(ErrorMessages, where_a_half_open_interval_stands_elsewhere) {
  EXPECT_EQ(messages("let a = [0, 1)\n"),
            "a.seam:1:14: error: expected ',', ';' or ']' after '1'\n"
            "  1 | let a = [0, 1)\n"
            "    |              ^\n"
            "    = '[' was opened at 1:9\n");
}

TEST(ErrorMessages, where_a_text_is_not_closed) {
  EXPECT_EQ(messages("section \"one\n"
                     "section \"two\"\n"),
            "a.seam:1:9: error: this text is not closed on its line\n"
            "  1 | section \"one\n"
            "    |         ^~~~\n"
            "    = texts end with '\"'\n");
}

TEST(ErrorMessages, where_a_title_has_no_quotes) {
  EXPECT_EQ(messages("section one\n"),
            "a.seam:1:9: error: expected a text in quotes after 'section'\n"
            "  1 | section one\n"
            "    |         ^~~\n");
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

TEST(ErrorMessages, where_an_id_is_used_twice) {
  EXPECT_EQ(messages("claim a: x = 1\n"
                     "claim b: x = 2\n"
                     "claim a: x = 3\n"),
            "a.seam:3:7: error: the id 'a' is used twice\n"
            "  3 | claim a: x = 3\n"
            "    |       ^\n"
            "    = the first is at 1:7\n");
}

TEST(ErrorMessages, where_a_clause_is_given_twice) {
  EXPECT_EQ(messages("claim a: x = 1\n"
                     "    expect refuted\n"
                     "    expect undecided\n"),
            "a.seam:3:5: error: this item has 'expect' twice\n"
            "  3 |     expect undecided\n"
            "    |     ^~~~~~\n"
            "    = the first is at 2:5\n");
}

TEST(ErrorMessages, where_an_expectation_is_unknown) {
  EXPECT_EQ(messages("claim a: x = 1\n"
                     "    expect proved\n"),
            "a.seam:2:12: error: expected 'refuted' or 'undecided' after 'expect'\n"
            "  2 |     expect proved\n"
            "    |            ^~~~~~\n");
}

TEST(ErrorMessages, where_two_items_share_a_line) {
  EXPECT_EQ(messages("let a = 1 let b = 2\n"),
            "a.seam:1:11: error: an item begins on a line of its own\n"
            "  1 | let a = 1 let b = 2\n"
            "    |           ^~~\n");
}

TEST(ErrorMessages, where_a_table_has_no_rows) {
  EXPECT_EQ(messages("table t for k in 1..3:\n"
                     "let x = 1\n"),
            "a.seam:1:23: error: expected a row, which begins with a text in quotes after ':'\n"
            "  1 | table t for k in 1..3:\n"
            "    |                       ^\n");
}

TEST(ErrorMessages, where_a_table_row_has_no_values) {
  EXPECT_EQ(messages("table t for k in 1..3:\n"
                     "    \"a\" x[k]\n"),
            "a.seam:2:13: error: expected '~' and the printed values after ']'\n"
            "  2 |     \"a\" x[k]\n"
            "    |             ^\n");
}

TEST(ErrorMessages, where_a_param_has_an_unknown_type) {
  EXPECT_EQ(messages("param a : real\n"),
            "a.seam:1:11: error: expected 'integer' or 'vector' and a dimension after ':'\n"
            "  1 | param a : real\n"
            "    |           ^~~~\n");
}

TEST(ErrorMessages, where_a_root_has_no_interval) {
  EXPECT_EQ(messages("root g of g^2 - 2\n"),
            "a.seam:1:18: error: expected 'in' and a set after '2'\n"
            "  1 | root g of g^2 - 2\n"
            "    |                  ^\n");
}

TEST(ErrorMessages, where_a_letter_is_not_of_the_language) {
  EXPECT_EQ(
      messages("let é = 1\n"),
      "a.seam:1:5: error: expected a name after 'let'\n"
      "  1 | let é = 1\n"
      "    |     ^\n"
      "    = names are made of the letters a to z, Greek letters, digits, '_', `'` and '.'\n");
}

TEST(ErrorMessages, where_several_items_are_wrong) {
  EXPECT_EQ(messages("let a = 1 +\n"
                     "let b = 2\n"
                     "let c = * 3\n"
                     "\n"
                     "claim d: x = \n"
                     "\n"
                     "let e = 5\n"),
            "a.seam:1:12: error: expected an expression after '+'\n"
            "  1 | let a = 1 +\n"
            "    |            ^\n"
            "a.seam:3:9: error: expected an expression after '='\n"
            "  3 | let c = * 3\n"
            "    |         ^\n"
            "a.seam:5:13: error: expected an expression after '='\n"
            "  5 | claim d: x = \n"
            "    |             ^\n");
}

TEST(ErrorMessages, where_the_file_is_not_utf8) {
  EXPECT_EQ(messages("let a = 1\nlet b = \x80\n"),
            "a.seam:2:9: error: this byte is not UTF-8\n"
            "  2 | let b = \uFFFD\n"
            "    |         ^\n"
            "    = save the file as UTF-8\n");
}

TEST(ErrorMessages, where_the_file_has_a_nul_byte) {
  EXPECT_EQ(messages(std::string("let a = 1\0\n", 11)),
            "a.seam:1:10: error: the invisible character U+0000 cannot stand here\n"
            "  1 | let a = 1\uFFFD\n"
            "    |          ^\n");
}

TEST(ErrorMessages, stop_after_a_hundred) {
  std::string bytes;
  for (int i = 0; i < 1000; ++i) bytes += "let a = \n";
  EXPECT_EQ(parse(std::make_shared<text::Source>(text::Source{"", bytes})).errors.size(), 100u);
}

TEST(ErrorMessages, leave_the_good_items_readable) {
  const auto parsed = parse(std::make_shared<text::Source>(text::Source{
      "", "let a = (1\n  + 2\nlet b = 2\nclaim c: )\n    expect refuted\nlet d = 3\n"}));
  EXPECT_EQ(parsed.errors.size(), 2u);
  ASSERT_EQ(parsed.file.items.size(), 2u);
  EXPECT_EQ(parsed.file.items[0].name, "b");
  EXPECT_EQ(parsed.file.items[1].name, "d");
}

}  // namespace
}  // namespace seam::claims
