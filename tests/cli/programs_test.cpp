// SPDX-License-Identifier: GPL-3.0-or-later
// What docs/command-line.md promises to users and scripts.

#include "programs.h"

#include <gtest/gtest.h>

namespace seam::test {
namespace {

TEST_F(Programs, the_exit_status_says_what_came_of_the_claims) {
  EXPECT_EQ(seamproof("verify right.seam").status, 0);
  EXPECT_EQ(seamproof("verify known.seam").status, 0);
  EXPECT_EQ(seamproof("verify wrong.seam").status, 1);
}

TEST_F(Programs, an_undecided_claim_gives_2_unless_that_is_allowed) {
  EXPECT_EQ(seamproof("verify hard.seam --effort 10").status, 2);
  EXPECT_EQ(seamproof("verify hard.seam --effort 10 --allow-undecided").status, 0);
}

TEST_F(Programs, evidence_that_shows_something_else_gives_3) {
  ASSERT_EQ(seamproof("verify known.seam --out out").status, 0);
  in_folder(
      "sed -i 's/\"verdict\": \"refuted\"/\"verdict\": \"proven\"/' out/certificates/a.json");
  EXPECT_EQ(check("out").status, 3);
}

TEST_F(Programs, an_internal_error_gives_70) {
  // Too little memory for what the claims say.
  std::string large;
  for (int i = 0; i < 200'000; ++i)
    large += "claim a" + std::to_string(i) + ": " + std::to_string(i) + " > 0\n";
  write("large.seam", large);
  const Finished finished =
      in_folder("ulimit -v 150000; exec " + quoted(SEAMPROOF) + " verify large.seam");
  EXPECT_EQ(finished.status, 70) << finished.output;
  EXPECT_NE(finished.output.find("internal error: "), std::string::npos) << finished.output;
}

TEST_F(Programs, the_exit_status_says_what_was_wrong_with_the_input) {
  EXPECT_EQ(seamproof("no-such-command").status, 64);
  EXPECT_EQ(seamproof("verify").status, 64);
  EXPECT_EQ(seamproof("verify broken.seam").status, 65);
  EXPECT_EQ(seamproof("verify missing.seam").status, 66);
}

TEST_F(Programs, a_slip_in_a_selected_id_is_named_and_nothing_passes) {
  write("two.seam",
        "claim smooth: 1 = 1\ntable t for k in 1..2: \"r\" k ~ 1, 2\nask q: 1 + 1\n");
  const Finished slip = seamproof("verify two.seam --claim smooth --claim smoth");
  EXPECT_EQ(slip.status, 64);
  EXPECT_NE(slip.output.find("did you mean 'smooth'?"), std::string::npos) << slip.output;
  EXPECT_NE(seamproof("verify two.seam --claim t").output.find("write 't.*'"),
            std::string::npos);
  EXPECT_EQ(seamproof("verify two.seam --claim 't.*' --claim q").status, 0);
}

TEST_F(Programs, an_option_that_may_be_repeated_takes_one_value_at_a_time) {
  EXPECT_EQ(seamproof("verify --claim a --claim 'a*' right.seam").status, 0);
}

TEST_F(Programs, a_number_that_must_be_above_0_says_so) {
  const Finished finished = seamproof("verify right.seam --timeout 0");
  EXPECT_EQ(finished.status, 64);
  EXPECT_NE(finished.output.find("'0' is no number above 0"), std::string::npos)
      << finished.output;
}

TEST_F(Programs, every_id_that_is_listed_can_be_verified_alone) {
  write("table.seam",
        "table t for k in 1..2 labelled \"one\", \"two\":\n    \"square\" k^2 ~ 1, 4\n");
  EXPECT_EQ(seamproof("list table.seam right.seam").output, "t.square.one\nt.square.two\na\n");
  EXPECT_EQ(seamproof("verify table.seam --claim t.square.two").status, 0);
}

TEST_F(Programs, what_may_follow_on_the_command_line_is_known_without_a_shell) {
  EXPECT_EQ(seamproof("complete expl").output,
            "explain\twhat a claim was turned into and how it was decided\n");
  EXPECT_EQ(seamproof("complete verify ''").output, "/*.seam\n");
  EXPECT_EQ(seamproof("complete explain right.seam ''").output, "a\t\n");
  EXPECT_EQ(seamproof("complete explain broken.seam ''").output, "");
  EXPECT_EQ(seamproof("complete no-such-command --x ''").status, 0);
}

TEST_F(Programs, an_output_folder_that_cannot_be_made_gives_74) {
  EXPECT_EQ(seamproof("verify right.seam --out right.seam/out").status, 74);
}

TEST_F(Programs, the_certificates_that_are_written_are_accepted) {
  ASSERT_EQ(seamproof("verify right.seam --out out").status, 0);
  EXPECT_EQ(check("out").status, 0);
}

TEST_F(Programs, the_outputs_are_the_same_when_made_again) {
  ASSERT_EQ(seamproof("verify right.seam known.seam --out one --jobs 1").status, 0);
  ASSERT_EQ(seamproof("verify right.seam known.seam --out two --jobs 2").status, 0);
  EXPECT_EQ(in_folder("diff -r one two").output, "");
}

TEST_F(Programs, the_checker_sees_the_statements_that_the_claims_say) {
  ASSERT_EQ(seamproof("verify right.seam --out out").status, 0);
  const std::string digest = seamproof("obligations right.seam").output.substr(0, 16);
  EXPECT_NE(check("out").output.find(digest), std::string::npos) << digest;
}

TEST_F(Programs, a_certificate_for_another_claim_does_not_pass_for_this_one) {
  ASSERT_EQ(seamproof("verify right.seam --out right").status, 0);
  ASSERT_EQ(seamproof("verify known.seam --out known").status, 0);
  std::string forged = read("known/certificates/a.json");
  const std::size_t at = forged.find("\"refuted\"");
  ASSERT_NE(at, std::string::npos);
  write("forged.json", forged.replace(at, 9, "\"proven\""));
  EXPECT_NE(check("forged.json").status, 0);
}

TEST_F(Programs, the_checker_takes_no_nonsense_and_does_not_crash) {
  for (const std::string text :
       {"", "{}", "[[[[", "{\"format\": \"seamproof certificate 1\"}", "\xFF\xFE"}) {
    write("nonsense.json", text);
    const int status = check("nonsense.json").status;
    EXPECT_NE(status, 0) << text;
    EXPECT_LT(status, 128) << text;
  }
  EXPECT_EQ(check("missing.json").status, 66);
}

TEST_F(Programs, json_goes_to_standard_output_alone) {
  const Finished finished = seamproof("verify right.seam --json - 2>/dev/null");
  EXPECT_EQ(finished.output.substr(0, 1), "{");
  EXPECT_NE(finished.output.find("\"verdict\": \"proven\""), std::string::npos);
}

TEST_F(Programs, output_that_is_no_terminal_has_no_colours_unless_asked) {
  EXPECT_EQ(seamproof("verify right.seam").output.find('\033'), std::string::npos);
  EXPECT_NE(seamproof("verify right.seam --color always").output.find('\033'),
            std::string::npos);
}

TEST_F(Programs, a_new_file_verifies) {
  ASSERT_EQ(seamproof("new first").status, 0);
  EXPECT_EQ(seamproof("verify first.seam").status, 0);
}

TEST_F(Programs, trust_names_what_a_verdict_rests_on_and_nothing_else) {
  write("rests.seam",
        "param c in (0, 1)\nlet f(x) = c*x\nlet g = 7\n"
        "claim a: c > 0\nclaim b: f(2) > 0\n    using a\nclaim d: g = 7\n");
  const Finished finished = seamproof("trust rests.seam b");
  EXPECT_EQ(finished.status, 0);
  for (const char* expected :
       {"b: proven", "let f(x) = c*x", "param c in (0, 1)", "the claim a, proven",
        "certificates/a.json", "certificates/b.json", "Boost", "GiNaC"})
    EXPECT_NE(finished.output.find(expected), std::string::npos) << expected;
  EXPECT_EQ(finished.output.find("g = 7"), std::string::npos);
}

}  // namespace
}  // namespace seam::test
