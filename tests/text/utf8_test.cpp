// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "text/utf8.h"

#include <gtest/gtest.h>

namespace seam::text {
namespace {

TEST(Utf8, decodes_each_length) {
  EXPECT_EQ(decode("a", 0).value, U'a');
  EXPECT_EQ(decode("γ", 0).value, U'γ');
  EXPECT_EQ(decode("√", 0).value, U'√');
  EXPECT_EQ(decode("𝄞", 0).value, U'𝄞');
  EXPECT_EQ(decode("𝄞", 0).length, 4u);
}

TEST(Utf8, finds_the_first_byte_that_is_none) {
  EXPECT_FALSE(invalid_utf8("aγ√𝄞"));
  EXPECT_EQ(invalid_utf8("ab\x80"), 2u);            // a continuation byte alone
  EXPECT_EQ(invalid_utf8("a\xC0\xAF"), 1u);         // overlong
  EXPECT_EQ(invalid_utf8("\xE0\x80\xAF"), 0u);      // overlong
  EXPECT_EQ(invalid_utf8("\xED\xA0\x80"), 0u);      // a surrogate
  EXPECT_EQ(invalid_utf8("\xF4\x90\x80\x80"), 0u);  // above 10FFFF
  EXPECT_EQ(invalid_utf8("√\xE2\x88"), 3u);         // cut short
}

TEST(Utf8, names_code_points) {
  EXPECT_EQ(code_name(0xE9), "U+00E9");
  EXPECT_EQ(code_name(0x1D11E), "U+1D11E");
}

TEST(Utf8, knows_what_cannot_be_seen) {
  EXPECT_TRUE(invisible(0));
  EXPECT_TRUE(invisible(0x1B));
  EXPECT_TRUE(invisible(0x202E));
  EXPECT_FALSE(invisible('\t'));
  EXPECT_FALSE(invisible(U'α'));
}

}  // namespace
}  // namespace seam::text
