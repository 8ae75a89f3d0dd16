// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/terminal.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "sample.h"

namespace seam::report {
namespace {

TEST(Terminal, in_full_a_claim_says_how_it_was_decided_and_whether_anew) {
  ClaimRun claim;
  claim.id = "a";
  claim.printed.verdict = Verdict::proven;
  claim.printed.method = {"subdivision", "normal form"};
  claim.printed.obligations.resize(3);
  EXPECT_EQ(line(claim, false, Detail::full),
            "✓ proven       a  [subdivision, normal form; 3 obligations; searched]  0.00 s\n");
  claim.printed.is_stored = true;
  EXPECT_EQ(line(claim, false, Detail::full),
            "✓ proven       a  [subdivision, normal form; 3 obligations; stored]  0.00 s\n");
}

TEST(Terminal, a_line_holds_verdict_id_and_time) {
  ClaimRun claim;
  claim.id = "a.b";
  claim.printed.verdict = Verdict::proven;
  claim.seconds = 0.123;
  EXPECT_EQ(line(claim, false), "✓ proven       a.b  0.12 s\n");
}

TEST(Terminal, a_refuted_claim_shows_its_witness_and_what_was_expected) {
  ClaimRun claim;
  claim.id = "a";
  claim.printed.verdict = Verdict::refuted;
  claim.printed.witness = "u = 0: 1 != 2";
  EXPECT_EQ(line(claim, false),
            "✗ refuted      a  u = 0: 1 != 2  (expected: proven)  0.00 s\n");
}

TEST(Terminal, an_undecided_claim_shows_its_reason) {
  ClaimRun claim;
  claim.id = "a";
  claim.expected = Verdict::undecided;
  claim.printed.reason = "effort";
  claim.printed.detail = "20 pieces";
  EXPECT_EQ(line(claim, false), "? undecided    a  effort: 20 pieces  0.00 s\n");
}

TEST(Terminal, text_of_a_file_cannot_move_the_cursor_or_begin_a_line) {
  ClaimRun claim;
  claim.id = "a";
  claim.printed.verdict = Verdict::refuted;
  claim.printed.witness = "\033[2J\nproven";
  const std::string shown = line(claim, false);
  EXPECT_EQ(shown.find('\033'), std::string::npos);
  EXPECT_EQ(std::ranges::count(shown, '\n'), 1);
}

TEST(Terminal, a_long_witness_is_cut_between_code_points) {
  ClaimRun claim;
  claim.id = "a";
  claim.printed.verdict = Verdict::refuted;
  for (int i = 0; i < 500; ++i) claim.printed.witness += "√";
  EXPECT_NE(line(claim, false).find("√…  (exp"), std::string::npos);
  EXPECT_LT(line(claim, false).size(), 600u);
}

TEST(Terminal, colour_is_added_to_the_word_and_never_stands_for_it) {
  const std::string plain = terminal(sample(), false), coloured = terminal(sample(), true);
  EXPECT_EQ(plain.find('\033'), std::string::npos);
  EXPECT_NE(coloured.find("\033[32m✓ proven"), std::string::npos);
}

TEST(Terminal, the_last_line_is_the_summary) {
  const std::string shown = terminal(sample(), false);
  EXPECT_TRUE(shown.ends_with(
      "\n10 claims: 5 proven, 3 refuted, 1 conditional, 1 undecided; 7 as expected\n"))
      << shown;
}

TEST(Terminal, NO_COLOR_counts_unless_colour_is_asked_for) {
  EXPECT_TRUE(wants_colour(Colour::automatic, true, nullptr));
  EXPECT_TRUE(wants_colour(Colour::automatic, true, ""));
  EXPECT_FALSE(wants_colour(Colour::automatic, true, "1"));
  EXPECT_FALSE(wants_colour(Colour::automatic, false, nullptr));
  EXPECT_TRUE(wants_colour(Colour::always, false, "1"));
  EXPECT_FALSE(wants_colour(Colour::never, true, nullptr));
}

ClaimRun with_slacks(std::vector<Slack> slacks) {
  ClaimRun claim;
  claim.id = "a";
  claim.printed.verdict = Verdict::proven;
  for (Slack& slack : slacks) {
    claim.printed.obligations.emplace_back();
    claim.printed.obligations.back().slack = std::move(slack);
  }
  return claim;
}

TEST(Terminal, the_least_slack_above_0_is_shown_in_full_detail) {
  const ClaimRun claim =
      with_slacks({{"0", "0", "u = 0", "", ""},
                   {"0.5", "0.6", "u = 1", "", ""},
                   {"0.0123", "0.0125", "u = 1/2", "the difference of the sides", ""},
                   {"", "", "", "", "its formula is long"}});
  const std::string shown = line(claim, false, Detail::full);
  EXPECT_NE(shown.find("slack between 0.0123 and 0.0125, the latter at u = 1/2 (the difference "
                       "of the sides)\n"),
            std::string::npos)
      << shown;
  EXPECT_EQ(line(claim, false).find("slack"), std::string::npos);
}

TEST(Terminal, a_slack_is_said_in_words) {
  EXPECT_EQ(in_words({"0", "0", "u = 0", "", ""}), "0, attained at u = 0");
  EXPECT_EQ(in_words({"1/600", "1/600", "", "", ""}), "1/600");
  EXPECT_EQ(in_words({"0.1", "", "", "", ""}), "0.1 or more");
  EXPECT_EQ(in_words({"", "", "", "", "it is long"}), "not computed: it is long");
}

}  // namespace
}  // namespace seam::report
