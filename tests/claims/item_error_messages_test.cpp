// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tree.h"

namespace seam::claims {
namespace {

std::string messages(const std::string& bytes) {
  return messages(parse(source(bytes)));
}

TEST(ItemErrorMessages, where_a_colon_is_missing) {
  EXPECT_EQ(messages("claim a.b x = 1\n"),
            "a.seam:1:11: error: expected ':' before the statement\n"
            "  1 | claim a.b x = 1\n"
            "    |           ^\n");
}

TEST(ItemErrorMessages, where_a_colon_that_touches_a_word_belongs_to_the_id) {
  EXPECT_EQ(
      messages("claim a:x = 1\n"),
      "a.seam:1:11: error: expected ':' before the statement\n"
      "  1 | claim a:x = 1\n"
      "    |           ^\n"
      "    = a ':' that touches the next word belongs to the id: put a blank behind it\n");
}

TEST(ItemErrorMessages, where_a_claim_has_no_statement) {
  EXPECT_EQ(messages("claim a.b:\n"
                     "\n"
                     "let x = 1\n"),
            "a.seam:1:7: error: this claim has no statement\n"
            "  1 | claim a.b:\n"
            "    |       ^~~\n"
            "    = a statement stands after ':'\n");
}

TEST(ItemErrorMessages, where_a_claim_has_a_clause_and_no_statement) {
  EXPECT_EQ(messages("claim a.b:\n"
                     "    expect refuted\n"),
            "a.seam:1:7: error: this claim has no statement\n"
            "  1 | claim a.b:\n"
            "    |       ^~~\n"
            "    = a statement stands after ':'\n");
}

TEST(ItemErrorMessages, where_a_clause_is_misspelled) {
  EXPECT_EQ(messages("claim a: x = 1\n"
                     "    corected: x = 2\n"),
            "a.seam:2:5: error: unknown clause 'corected'\n"
            "  2 |     corected: x = 2\n"
            "    |     ^~~~~~~~\n"
            "    = did you mean 'corrected'?\n");
}

TEST(ItemErrorMessages, where_a_clause_is_unknown) {
  EXPECT_EQ(messages("claim a: x = 1\n"
                     "    because: x = 2\n"),
            "a.seam:2:5: error: unknown clause 'because'\n"
            "  2 |     because: x = 2\n"
            "    |     ^~~~~~~\n");
}

TEST(ItemErrorMessages, where_an_item_is_misspelled) {
  EXPECT_EQ(messages("clam a: x = 1\n"),
            "a.seam:1:1: error: unknown item 'clam'\n"
            "  1 | clam a: x = 1\n"
            "    | ^~~~\n"
            "    = did you mean 'claim'?\n");
}

TEST(ItemErrorMessages, where_an_item_is_misspelled_after_a_definition) {
  EXPECT_EQ(messages("let a = 1\n"
                     "lte b = 2\n"),
            "a.seam:2:1: error: unknown item 'lte'\n"
            "  2 | lte b = 2\n"
            "    | ^~~\n"
            "    = did you mean 'let'?\n");
}

TEST(ItemErrorMessages, where_something_else_stands_where_an_item_should) {
  EXPECT_EQ(messages("(1)\n"),
            "a.seam:1:1: error: expected an item, such as 'let' or 'claim'\n"
            "  1 | (1)\n"
            "    | ^\n");
}

TEST(ItemErrorMessages, where_a_text_is_not_closed) {
  EXPECT_EQ(messages("section \"one\n"
                     "section \"two\"\n"),
            "a.seam:1:9: error: this text is not closed on its line\n"
            "  1 | section \"one\n"
            "    |         ^~~~\n"
            "    = texts end with '\"'\n");
}

TEST(ItemErrorMessages, where_a_title_has_no_quotes) {
  EXPECT_EQ(messages("section one\n"),
            "a.seam:1:9: error: expected a text in quotes after 'section'\n"
            "  1 | section one\n"
            "    |         ^~~\n");
}

TEST(ItemErrorMessages, where_an_id_is_used_twice) {
  EXPECT_EQ(messages("claim a: x = 1\n"
                     "claim b: x = 2\n"
                     "claim a: x = 3\n"),
            "a.seam:3:7: error: the id 'a' is used twice\n"
            "  3 | claim a: x = 3\n"
            "    |       ^\n"
            "    = the first is at 1:7\n");
}

TEST(ItemErrorMessages, where_a_clause_is_given_twice) {
  EXPECT_EQ(messages("claim a: x = 1\n"
                     "    expect refuted\n"
                     "    expect undecided\n"),
            "a.seam:3:5: error: this item has 'expect' twice\n"
            "  3 |     expect undecided\n"
            "    |     ^~~~~~\n"
            "    = the first is at 2:5\n");
}

TEST(ItemErrorMessages, where_an_expectation_is_unknown) {
  EXPECT_EQ(messages("claim a: x = 1\n"
                     "    expect proved\n"),
            "a.seam:2:12: error: expected 'refuted' or 'undecided' after 'expect'\n"
            "  2 |     expect proved\n"
            "    |            ^~~~~~\n");
}

TEST(ItemErrorMessages, where_two_items_share_a_line) {
  EXPECT_EQ(messages("let a = 1 let b = 2\n"),
            "a.seam:1:11: error: an item begins on a line of its own\n"
            "  1 | let a = 1 let b = 2\n"
            "    |           ^~~\n");
}

TEST(ItemErrorMessages, where_a_table_has_no_rows) {
  EXPECT_EQ(messages("table t for k in 1..3:\n"
                     "let x = 1\n"),
            "a.seam:1:23: error: expected a row, which begins with a text in quotes after ':'\n"
            "  1 | table t for k in 1..3:\n"
            "    |                       ^\n");
}

TEST(ItemErrorMessages, where_a_table_row_has_no_values) {
  EXPECT_EQ(messages("table t for k in 1..3:\n"
                     "    \"a\" x[k]\n"),
            "a.seam:2:13: error: expected '~' and the printed values after ']'\n"
            "  2 |     \"a\" x[k]\n"
            "    |             ^\n");
}

TEST(ItemErrorMessages, where_a_param_has_an_unknown_type) {
  EXPECT_EQ(messages("param a : real\n"),
            "a.seam:1:11: error: expected 'integer', 'vector' and a dimension, or 'function' "
            "after ':'\n"
            "  1 | param a : real\n"
            "    |           ^~~~\n");
}

TEST(ItemErrorMessages, where_a_root_has_no_interval) {
  EXPECT_EQ(messages("root g of g^2 - 2\n"),
            "a.seam:1:18: error: expected 'in' and a set after '2'\n"
            "  1 | root g of g^2 - 2\n"
            "    |                  ^\n");
}

TEST(ItemErrorMessages, where_a_letter_is_not_of_the_language) {
  EXPECT_EQ(
      messages("let é = 1\n"),
      "a.seam:1:5: error: expected a name after 'let'\n"
      "  1 | let é = 1\n"
      "    |     ^\n"
      "    = names are made of the letters a to z, Greek letters, digits, '_', `'` and '.'\n");
}

TEST(ItemErrorMessages, where_several_items_are_wrong) {
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

TEST(ItemErrorMessages, where_the_file_is_not_utf8) {
  EXPECT_EQ(messages("let a = 1\nlet b = \x80\n"),
            "a.seam:2:9: error: this byte is not UTF-8\n"
            "  2 | let b = \uFFFD\n"
            "    |         ^\n"
            "    = save the file as UTF-8\n");
}

TEST(ItemErrorMessages, where_the_file_has_a_nul_byte) {
  EXPECT_EQ(messages(std::string("let a = 1\0\n", 11)),
            "a.seam:1:10: error: the invisible character U+0000 cannot stand here\n"
            "  1 | let a = 1\uFFFD\n"
            "    |          ^\n");
}

TEST(ItemErrorMessages, stop_after_a_hundred) {
  std::string bytes;
  for (int i = 0; i < 1000; ++i) bytes += "let a = \n";
  EXPECT_EQ(parse(source(bytes)).errors.size(), 100u);
}

TEST(ItemErrorMessages, leave_the_good_items_readable) {
  const auto parsed = parse(std::make_shared<text::Source>(text::Source{
      "", "let a = (1\n  + 2\nlet b = 2\nclaim c: )\n    expect refuted\nlet d = 3\n"}));
  EXPECT_EQ(parsed.errors.size(), 2u);
  ASSERT_EQ(parsed.file.items.size(), 2u);
  EXPECT_EQ(parsed.file.items[0].name, "b");
  EXPECT_EQ(parsed.file.items[1].name, "d");
}

TEST(ItemErrorMessages, where_a_figure_is_drawn_with_something_unknown) {
  EXPECT_EQ(messages("figure \"S\": S with nets\n"),
            "a.seam:1:20: error: a figure cannot be drawn with 'nets'\n"
            "  1 | figure \"S\": S with nets\n"
            "    |                    ^~~~\n"
            "    = did you mean 'net'?\n");
  EXPECT_EQ(messages("figure \"S\": S with shadow\n"),
            "a.seam:1:20: error: a figure cannot be drawn with 'shadow'\n"
            "  1 | figure \"S\": S with shadow\n"
            "    |                    ^~~~~~\n"
            "    = it can with 'net', 'curvature_lines', 'contours'\n");
}

TEST(ItemErrorMessages, where_a_clause_of_a_figure_is_misspelled) {
  EXPECT_EQ(messages("figure \"S\": S colored by gauss\n"),
            "a.seam:1:15: error: unknown clause 'colored'\n"
            "  1 | figure \"S\": S colored by gauss\n"
            "    |               ^~~~~~~\n"
            "    = did you mean 'coloured'?\n");
}

TEST(ItemErrorMessages, where_a_figure_is_coloured_twice) {
  EXPECT_EQ(messages("figure \"S\": S coloured by x coloured by y\n"),
            "a.seam:1:29: error: this item has 'coloured' twice\n"
            "  1 | figure \"S\": S coloured by x coloured by y\n"
            "    |                             ^~~~~~~~\n"
            "    = the first is at 1:15\n");
}

TEST(ItemErrorMessages, where_a_figure_has_no_title) {
  EXPECT_EQ(messages("figure a: S\n"),
            "a.seam:1:9: error: expected a text in quotes after 'a'\n"
            "  1 | figure a: S\n"
            "    |         ^\n");
}

TEST(ItemErrorMessages, where_two_figures_have_one_id) {
  EXPECT_EQ(messages("figure a \"S\": S\nfigure a \"T\": T\n"),
            "a.seam:2:8: error: the id 'a' is used twice\n"
            "  2 | figure a \"T\": T\n"
            "    |        ^\n"
            "    = the first is at 1:8\n");
}

}  // namespace
}  // namespace seam::claims
