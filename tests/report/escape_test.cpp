// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/escape.h"

#include <gtest/gtest.h>

namespace seam::report {
namespace {

TEST(Escape, plain_words_pass) {
  EXPECT_EQ(escape("Table 2 (a)."), "Table 2 (a).");
}

TEST(Escape, what_means_something_to_TeX_is_printed) {
  EXPECT_EQ(escape("\\x{$}"), "\\textbackslash{}x\\{\\$\\}");
  EXPECT_EQ(escape("100% & #1"), "100\\% \\& \\#1");
  EXPECT_EQ(escape("^^5c"), "\\textasciicircum{}\\textasciicircum{}5c");
}

TEST(Escape, two_signs_never_become_another_one) {
  EXPECT_EQ(escape("--"), "-{}-{}");
  EXPECT_EQ(escape("``"), "\\textasciigrave{}\\textasciigrave{}");
}

TEST(Escape, letters_of_the_field_and_of_names_have_their_print) {
  EXPECT_EQ(escape("α ≤ √2"), "$\\alpha$ $\\leq$ $\\surd$2");
  EXPECT_EQ(escape("Bézier, Gauß"), "Bézier,\\allowbreak{} Gauß");
}

TEST(Escape, an_unknown_character_is_printed_by_its_number) {
  EXPECT_EQ(escape("汉"), "[U+6C49]");
  EXPECT_EQ(escape("\x07"), "[U+0007]");
  EXPECT_EQ(escape(std::string(1, '\0')), "[U+0000]");
  EXPECT_EQ(escape("\U0001F600"), "[U+1F600]");
}

TEST(Escape, bytes_that_are_not_text_are_printed_one_by_one) {
  EXPECT_EQ(escape("\xFF"), "[byte FF]");
  EXPECT_EQ(escape("\xE2\x82"), "[byte E2][byte 82]");
  EXPECT_EQ(escape("\xC0\xAF"), "[byte C0][byte AF]");  // overlong
  EXPECT_EQ(escape("\xE0\x80\xAF"), "[byte E0][byte 80][byte AF]\\allowbreak{}");
  EXPECT_EQ(escape("\xF5"), "[byte F5]");
}

TEST(Escape, every_byte_alone_gives_text_without_a_bare_special_character) {
  for (int byte = 0; byte < 256; ++byte) {
    const std::string latex = escape(std::string(1, static_cast<char>(byte)));
    EXPECT_FALSE(latex.empty());
    if (latex.size() == 1) {
      EXPECT_EQ(std::string("\\{}$&#%_^~").find(latex), std::string::npos);
    }
  }
}

TEST(Escape, an_accent_joins_the_letter_before_it) {
  EXPECT_EQ(escape("α\u0302"), "$\\hat{\\alpha}$");
  EXPECT_EQ(escape("x\u0302"), "\\^{x}");
  EXPECT_EQ(escape("e\u0301i\u0308"), "\\'{e}\\\"{\\i}");
  EXPECT_EQ(escape("v\u20D7"), "$\\vec{v}$");
}

TEST(Escape, an_accent_without_a_letter_to_stand_on_is_printed_by_its_number) {
  EXPECT_EQ(escape("\u0302"), "[U+0302]");
  EXPECT_EQ(escape("≤\u0302"), "$\\leq$[U+0302]");
  EXPECT_EQ(escape("1\u0302"), "1[U+0302]");
  EXPECT_EQ(escape("α\u0327"), "$\\alpha$[U+0327]");
  EXPECT_EQ(escape("x\u0302\u0302"), "\\^{x}[U+0302]");
}

TEST(Escape, a_long_word_may_be_broken) {
  EXPECT_NE(escape(std::string(20, 'x')).find("\\allowbreak{}"), std::string::npos);
}

}  // namespace
}  // namespace seam::report
