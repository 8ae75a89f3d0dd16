// SPDX-License-Identifier: GPL-3.0-or-later
// JUnit XML, SARIF and what GitHub Actions reads.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "report/github.h"
#include "report/junit.h"
#include "report/sarif.h"
#include "report/terminal.h"
#include "sample.h"
#include "well_formed.h"

namespace seam::report {
namespace {

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

ClaimRun claim(const std::string& id, Verdict verdict, Verdict expected = Verdict::proven) {
  ClaimRun result;
  result.id = id;
  result.printed.verdict = verdict;
  result.printed.text = "1 = 1";
  result.expected = expected;
  result.line = 7;
  result.column = 3;
  return result;
}

report::Run run_of(std::vector<ClaimRun> claims) {
  FileRun file;
  file.file = "a.seam";
  file.path = "some folder/a.seam";
  for (ClaimRun& one : claims) file.items.push_back(std::move(one));
  return {"seamproof 9.9.9", {std::move(file)}};
}

ClaimRun with_alarm() {
  ClaimRun result = claim("alarm", Verdict::undecided);
  result.printed.alarm = "zero: not this one";
  return result;
}

TEST(CiFormats, a_warning_is_a_note_and_changes_no_exit_status) {
  report::Run run = run_of({claim("a", Verdict::proven)});
  run.files[0].warnings = {
      {"same-sides", "a", "both sides are the same", "it holds anyway", 7, 9}};
  EXPECT_EQ(exit_status(run), 0);
  EXPECT_TRUE(
      holds(github_annotations(run, false),
            "::notice file=some folder/a.seam,line=7,col=9,title=same-sides::both sides "
            "are the same; it holds anyway\n"));
  const auto log = nlohmann::json::parse(sarif(run, false));
  const auto& result = log["runs"][0]["results"][0];
  EXPECT_EQ(result["level"], "note");
  EXPECT_EQ(result["ruleId"], "SEAM1005");
  EXPECT_EQ(warnings(run),
            "some folder/a.seam:7:9: warning: both sides are the same [same-sides]\n"
            "  hint: it holds anyway\n");
}

TEST(CiFormats, a_claim_asks_for_attention_as_the_exit_status_says) {
  EXPECT_EQ(concern(claim("a", Verdict::proven)), Concern::none);
  EXPECT_EQ(concern(claim("a", Verdict::refuted, Verdict::refuted)), Concern::none);
  EXPECT_EQ(concern(claim("a", Verdict::refuted)), Concern::contradiction);
  EXPECT_EQ(concern(claim("a", Verdict::conditional)), Concern::undecided);
  EXPECT_EQ(concern(with_alarm()), Concern::alarm);
  ClaimRun erratum = claim("a", Verdict::refuted, Verdict::refuted);
  erratum.corrected = Outcome{};
  EXPECT_EQ(concern(erratum), Concern::undecided);
  erratum.corrected->verdict = Verdict::refuted;
  EXPECT_EQ(concern(erratum), Concern::contradiction);
}

TEST(CiFormats, junit_has_a_test_a_claim_and_says_how_it_ended) {
  const report::Run run = run_of({claim("a", Verdict::proven), claim("b", Verdict::refuted),
                                  claim("c", Verdict::undecided), with_alarm()});
  const std::string strict = junit(run, false), lenient = junit(run, true);
  EXPECT_TRUE(holds(strict, R"(tests="4" failures="2" errors="1" skipped="0")")) << strict;
  EXPECT_TRUE(holds(lenient, R"(tests="4" failures="1" errors="1" skipped="1")")) << lenient;
  EXPECT_TRUE(holds(strict, R"(<testcase name="b" classname="some folder/a.seam")"));
}

TEST(CiFormats, sarif_has_a_result_with_its_place_for_what_is_not_as_expected) {
  const report::Run run = run_of({claim("a", Verdict::proven), claim("b", Verdict::refuted),
                                  claim("c", Verdict::undecided), with_alarm()});
  const auto results = nlohmann::json::parse(sarif(run, false)).at("runs").at(0).at("results");
  ASSERT_EQ(results.size(), 3);
  EXPECT_EQ(results[0]["ruleId"], "SEAM1001");
  EXPECT_EQ(results[1]["level"], "warning");
  EXPECT_EQ(results[2]["ruleId"], "SEAM1003");
  const auto place = results[0]["locations"][0]["physicalLocation"];
  EXPECT_EQ(place["artifactLocation"]["uri"], "some%20folder/a.seam");
  EXPECT_EQ(place["region"]["startLine"], 7);
  const auto allowed = nlohmann::json::parse(sarif(run, true)).at("runs").at(0).at("results");
  EXPECT_EQ(allowed[1]["kind"], "open");
  EXPECT_EQ(allowed[1]["level"], "none");
}

TEST(CiFormats, a_claim_of_an_included_file_is_placed_there) {
  ClaimRun included = claim("b", Verdict::refuted);
  included.included = "parts/b.seam";
  const report::Run run = run_of({included});
  EXPECT_TRUE(holds(sarif(run, false), "some%20folder/parts/b.seam"));
  EXPECT_TRUE(holds(github_annotations(run, false), "file=some folder/parts/b.seam,line=7"));
}

TEST(CiFormats, errors_in_a_file_are_told_in_every_format) {
  report::Run run = run_of({});
  run.files[0].errors.push_back({"unknown name 'x'", "did you mean 'y'?", 4, 9});
  EXPECT_TRUE(holds(junit(run, true), R"(errors="1")"));
  EXPECT_TRUE(holds(sarif(run, true), "SEAM1004"));
  EXPECT_TRUE(holds(github_annotations(run, true), "::error file=some folder/a.seam,line=4"));
}

TEST(CiFormats, no_text_begins_a_command_or_ends_one) {
  ClaimRun hostile = claim("x", Verdict::refuted);
  hostile.printed.witness = "a\n::error::b\r%0A";
  hostile.id = "i,d:x\n";
  const std::string lines = github_annotations(run_of({hostile}), false);
  EXPECT_EQ(std::ranges::count(lines, '\n'), 1);
  EXPECT_TRUE(holds(lines, "title=i%2Cd%3Ax%0A::")) << lines;
  EXPECT_TRUE(holds(lines, "a%0A::error::b%0D%250A")) << lines;
}

TEST(CiFormats, no_text_is_a_link_in_a_message_of_sarif) {
  ClaimRun hostile = claim("x", Verdict::refuted);
  hostile.title = "[see](https://example.org) [here](1)";
  const auto log = nlohmann::json::parse(sarif(run_of({hostile}), false));
  const std::string text = log["runs"][0]["results"][0]["message"]["text"];
  EXPECT_TRUE(holds(text, R"([see\](https://example.org) [here\](1))")) << text;
}

// The sample holds hostile text.
TEST(CiFormats, hostile_text_stays_text) {
  EXPECT_EQ(not_well_formed(github_summary(sample())), "");
  const std::string xml = junit(sample(), false);
  EXPECT_EQ(not_well_formed(xml.substr(xml.find('\n') + 1)), "");
  EXPECT_TRUE(nlohmann::json::accept(sarif(sample(), false)));
}

}  // namespace
}  // namespace seam::report
