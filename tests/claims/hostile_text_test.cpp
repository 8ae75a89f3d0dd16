// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <chrono>

#include "tree.h"

// Whatever a file holds, reading it ends soon, with a tree of bounded height or a message.
namespace seam::claims {
namespace {

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int i = 0; i < times; ++i) all += text;
  return all;
}

std::string first_message(const std::string& bytes) {
  const Parsed parsed = parse(source(bytes));
  return parsed.errors.empty() ? "" : parsed.errors.front().message;
}

TEST(HostileText, nested_too_deeply_is_refused) {
  const std::string message = "this is nested more than 200 deep";
  for (const std::string open : {"(", "[", "f(", "-", "√", "2^", "curve [", "plane 1 ",
                                 "curve from ", "v[", "(0, ", "triangle_patch 1 { 1: "})
    EXPECT_EQ(first_message("let a = " + repeated(open, 100000) + "1"), message) << open;
  for (const std::string open : {"not ", "for all u: ", "a implies ", "(", "solve x: ",
                                 "f(u = ", "for u in [0, 1] where ", "f(1 for i in "})
    EXPECT_EQ(first_message("claim a: " + repeated(open, 100000) + "1"), message) << open;
}

TEST(HostileText, nested_deeply_is_read) {
  EXPECT_EQ(first_message("let a = " + repeated("(", 150) + "1" + repeated(")", 150)), "");
  EXPECT_EQ(first_message("claim a: " + repeated("not ", 150) + "1"), "");
}

TEST(HostileText, chained_too_long_is_refused) {
  const std::string message = "this is chained or nested more than 1000 operations deep";
  for (const std::string link : {"a+", "a*", "a/", "a-"})
    EXPECT_EQ(first_message("let a = " + repeated(link, 100000) + "1"), message) << link;
  for (const std::string link : {"a and ", "a or ", "a iff "})
    EXPECT_EQ(first_message("claim a: " + repeated(link, 100000) + "1"), message) << link;
  EXPECT_EQ(first_message("let a = f" + repeated("(x)", 100000)), message);
  EXPECT_EQ(first_message("let a = f" + repeated("[1]", 100000)), message);
}

TEST(HostileText, a_long_list_or_chain_of_relations_is_flat) {
  EXPECT_EQ(first_message("let a = [" + repeated("1, ", 100000) + "1]"), "");
  EXPECT_EQ(first_message("claim a: " + repeated("1 < ", 100000) + "1"), "");
}

TEST(HostileText, height_counts_across_brackets) {
  std::string text = "1";
  for (int i = 0; i < 20; ++i) text = "(" + text + ")" + repeated("+1", 100);
  EXPECT_NE(first_message("let a = " + text), "");
}

TEST(HostileText, bytes_that_are_no_text_are_refused) {
  EXPECT_EQ(first_message("let a = \x80"), "this byte is not UTF-8");
  EXPECT_EQ(first_message(std::string("let a = 1\0", 10)),
            "the invisible character U+0000 cannot stand here");
  EXPECT_EQ(first_message("let a = 1 # \xE2\x80\xAE"),
            "the invisible character U+202E cannot stand here");
}

TEST(HostileText, every_beginning_of_a_file_is_read_or_refused) {
  const std::string text =
      "paper \"P\" by \"A\"\nclaim a.b \"t\" at \"x\": for (u,v) in triangle where u < v: E ~ "
      "3.24 "
      "truncated\n  by split(u, 1/2)\nlet p = rational triangle_patch [ a:1, b:2; c:3; ] # γ\n"
      "table t for k in 1..2 labelled \"a\": \"r\" f(k)[1] ~ 1, 2\nlet q = curve 1 { 0: a; 1: "
      "√b }\n";
  for (std::size_t length = 0; length <= text.size(); ++length)
    for (const Parsed& parsed :
         {parse(source(text.substr(0, length))), parse(source(text.substr(length)))})
      for (const auto& error : parsed.errors) EXPECT_NE(text::render(error), "");
}

TEST(HostileText, every_file_with_one_byte_changed_is_read_or_refused) {
  const std::string text =
      "claim a.b \"t\" at \"x\": solve x in [0,1): f(x, u = 1) = [1, 2; 3, 4] where -x^2 < 1 "
      "gives (1, 2)\n"
      "let q = curve 1 { 0: a; 1: √b } + plane n(1) 2\nask a: limit(1/n for n -> infinity) "
      "digits 3\n";
  for (std::size_t i = 0; i < text.size(); ++i)
    for (const char c : std::string("\0\x80(){}[]:;,.\"#=<~ a1-\n√", 26)) {
      std::string changed = text;
      changed[i] = c;
      for (const auto& error : parse(source(changed)).errors)
        EXPECT_NE(text::render(error), "");
    }
}

TEST(HostileText, time_grows_with_the_length_only) {
  using clock = std::chrono::steady_clock;
  for (const std::string line : {"let a = 1 + b*c - f(x, y, z)/3\n", "let a = \n", "# remark\n",
                                 "clam a\n", "\"", "(((", "let a = \"", "claim a: x = 1\n"}) {
    const auto begin = clock::now();
    (void)parse(source(repeated(line, 300000 / static_cast<int>(line.size()))));
    EXPECT_LT(clock::now() - begin, std::chrono::seconds(20)) << line;
  }
}

}  // namespace
}  // namespace seam::claims
