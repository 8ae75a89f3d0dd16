// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "text/source.h"

#include <gtest/gtest.h>

namespace seam::text {
namespace {

Diagnostic at(const std::string& bytes, std::size_t begin, std::size_t end,
              std::string hint = {}) {
  return {{std::make_shared<Source>(Source{"a.seam", bytes}), begin, end},
          "wrong",
          std::move(hint)};
}

TEST(Position, counts_lines_and_code_points_from_one) {
  const Source source{"", "ab\nαβc\n"};
  EXPECT_EQ(position(source, 0).line, 1);
  EXPECT_EQ(position(source, 0).column, 1);
  EXPECT_EQ(position(source, 7).line, 2);
  EXPECT_EQ(position(source, 7).column, 3);
}

TEST(Position, of_an_offset_behind_the_end_is_the_end) {
  const Source source{"", "ab\n"};
  EXPECT_EQ(position(source, 100).line, 2);
  EXPECT_EQ(position(source, 100).column, 1);
}

TEST(Position, does_not_count_a_byte_order_mark) {
  const Source source{"",
                      "\xEF\xBB\xBF"
                      "ab"};
  EXPECT_EQ(position(source, 4).column, 2);
  EXPECT_EQ(position(source, 0).column, 1);
}

TEST(LineAt, leaves_out_the_line_end_of_either_kind) {
  const Source source{"", "ab\r\ncd\nef"};
  EXPECT_EQ(line_at(source, 1), "ab");
  EXPECT_EQ(line_at(source, 3), "ab");
  EXPECT_EQ(line_at(source, 4), "cd");
  EXPECT_EQ(line_at(source, 9), "ef");
}

TEST(Render, marks_the_place) {
  EXPECT_EQ(render(at("let a\nlet b = cde\n", 14, 17, "did you mean 'ede'?")),
            "a.seam:2:9: error: wrong\n"
            "  2 | let b = cde\n"
            "    |         ^~~\n"
            "    = did you mean 'ede'?\n");
}

TEST(Render, marks_by_code_points_and_shows_a_tab_as_one_column) {
  EXPECT_EQ(render(at("\tα x", 4, 5)),
            "a.seam:1:4: error: wrong\n"
            "  1 |  α x\n"
            "    |    ^\n");
}

TEST(Render, shows_a_window_of_a_long_line) {
  const std::string text =
      render(at(std::string(5000, 'a') + "!" + std::string(5000, 'b'), 5000, 5001));
  EXPECT_EQ(text, "a.seam:1:5001: error: wrong\n  1 | …" + std::string(60, 'a') + "!" +
                      std::string(39, 'b') + "…\n    | " + std::string(61, ' ') + "^\n");
}

TEST(Render, sends_no_control_characters_to_the_terminal) {
  const std::string text = render(at("a\x1B[31mb\x80\xE2\x80\xAE", 0, 1));
  EXPECT_EQ(text.find('\x1B'), std::string::npos);
  EXPECT_EQ(text.find('\x80' + std::string("\n")), std::string::npos);
  EXPECT_EQ(text.find("\xE2\x80\xAE"), std::string::npos);
}

TEST(Render, marks_the_end_of_an_empty_file) {
  EXPECT_EQ(render(at("", 0, 0)), "a.seam:1:1: error: wrong\n  1 | \n    | ^\n");
}

TEST(Nearest, finds_a_letter_left_out_put_in_replaced_or_exchanged) {
  const std::vector<std::string> known = {"corrected", "expect", "using", "gauss"};
  EXPECT_EQ(nearest("corected", known), "corrected");
  EXPECT_EQ(nearest("expectt", known), "expect");
  EXPECT_EQ(nearest("gausz", known), "gauss");
  EXPECT_EQ(nearest("uisng", known), "using");
}

TEST(Nearest, of_words_too_different_is_nothing) {
  EXPECT_EQ(nearest("mean", {"gauss"}), "");
  EXPECT_EQ(nearest("x", {"y"}), "");
  EXPECT_EQ(nearest("abcdefghijkl", {"abcdefxxxxkl"}), "");
  EXPECT_EQ(nearest(std::string(1000000, 'a'), {std::string(1000000, 'b')}), "");
}

}  // namespace
}  // namespace seam::text
