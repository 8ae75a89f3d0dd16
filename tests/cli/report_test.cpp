// SPDX-License-Identifier: GPL-3.0-or-later
// A report is made of results and certificates alone, and of nothing that these do not bear
// out.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "process.h"

namespace seam::test {
namespace {

namespace fs = std::filesystem;

class Report : public testing::Test {
 protected:
  Report() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    std::ofstream(folder_ / "a.seam")
        << "section \"One\"\nlet f(x) = x^2\n"
           "claim lemma: f(2) = 4\nclaim rest: f(3) > 8\n    using lemma\n"
           "claim wrong: f(2) = 5\n    corrected: f(2) = 4\nask root: sqrt(2)\n"
           "claim printed: sqrt(2) ~ 1.42\n    expect refuted\n";
    EXPECT_EQ(seamproof("verify a.seam --out one --html --fragments").status, 0);
  }
  ~Report() override { fs::remove_all(folder_); }

  Finished in_folder(const std::string& line) const {
    return run("cd " + quoted(folder_.string()) +
               " && export XDG_CACHE_HOME=\"$PWD/store\" && " + line);
  }
  Finished seamproof(const std::string& words) const {
    return in_folder(quoted(SEAMPROOF) + " " + words + " 2>&1");
  }
  void replace(const std::string& name, const std::string& from, const std::string& to) const {
    std::ifstream file(folder_ / name);
    std::string text{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    std::ofstream(folder_ / name) << text.replace(at, from.size(), to);
  }
  void expect_alarm(const std::string& objection) const {
    const Finished finished = seamproof("report one --out two");
    EXPECT_EQ(finished.status, 3);
    EXPECT_NE(finished.output.find(objection), std::string::npos) << finished.output;
  }

  fs::path folder_ = fs::path(testing::TempDir()) /
                     (std::string("seamproof_report_") +
                      testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(Report, from_a_folder_has_the_bytes_of_that_from_the_file) {
  EXPECT_EQ(seamproof("report one --out two --html --fragments").status, 0);
  EXPECT_EQ(in_folder("diff -r one two").output, "");
}

TEST_F(Report, from_the_folder_it_is_written_to_changes_nothing) {
  in_folder("cp -r one kept");
  EXPECT_EQ(seamproof("report one --out one --html --fragments").status, 0);
  EXPECT_EQ(in_folder("diff -r one kept").output, "");
}

TEST_F(Report, a_missing_certificate_is_an_alarm_and_what_rests_on_it_conditional) {
  fs::remove(folder_ / "one/certificates/lemma.json");
  const Finished finished = seamproof("report one --out two");
  EXPECT_EQ(finished.status, 3);
  EXPECT_NE(finished.output.find("lemma: the checker did not accept the evidence: "
                                 "its certificate is missing"),
            std::string::npos)
      << finished.output;
  EXPECT_NE(finished.output.find("1 conditional, 1 undecided"), std::string::npos)
      << finished.output;
}

TEST_F(Report, a_certificate_of_another_claim_is_an_alarm) {
  in_folder("cp one/certificates/rest.json one/certificates/lemma.json");
  expect_alarm("its certificate is that of another claim");
}

TEST_F(Report, a_certificate_of_another_statement_is_an_alarm) {
  in_folder("cp one/certificates/rest.json one/certificates/lemma.json");
  replace("one/certificates/lemma.json", "\"rest\"", "\"lemma\"");
  expect_alarm("its certificate is about another statement");
}

TEST_F(Report, a_certificate_that_cannot_be_read_is_an_alarm) {
  std::ofstream(folder_ / "one/certificates/lemma.json") << "[[";
  expect_alarm("its certificate cannot be read");
}

TEST_F(Report, a_verdict_that_the_evidence_does_not_show_is_an_alarm) {
  replace("one/results.json", "\"verdict\": \"refuted\"", "\"verdict\": \"proven\"");
  expect_alarm("its certificate says: refuted");
  replace("one/certificates/wrong.json", "\"refuted\"", "\"proven\"");
  expect_alarm("its evidence shows: refuted");
}

TEST_F(Report, a_verdict_without_a_certificate_is_an_alarm) {
  replace("one/results.json", "\"certificates/lemma.json\"", "null");
  expect_alarm("it has no certificate");
  replace("one/results.json", "\"certificates/rest.json\"", "\"../certificates/rest.json\"");
  expect_alarm("its certificate is not in the folder certificates");
}

TEST_F(Report, an_answer_whose_certificate_is_missing_is_withdrawn_with_an_alarm) {
  fs::remove(folder_ / "one/certificates/root.json");
  expect_alarm("root: the checker did not accept the evidence: its certificate is missing");
  EXPECT_EQ(in_folder("grep -c 1.4142 two/results.json").output, "0\n");
}

TEST_F(Report, true_digits_with_the_certificate_of_another_statement_are_withdrawn) {
  in_folder("cp one/certificates/printed.json 'one/certificates/printed~digits.json'");
  expect_alarm(
      "printed: the checker did not accept the evidence: "
      "its certificate is that of another claim");
  EXPECT_EQ(in_folder("grep -c '\"true_digits\"' two/results.json").output, "0\n");
}

TEST_F(Report, results_that_cannot_be_read_are_told_with_place_and_hint) {
  replace("one/results.json", "\"verdict\": \"proven\"", "\"verdict\": \"surely\"");
  const Finished finished = seamproof("report one --out two");
  EXPECT_EQ(finished.status, 65);
  EXPECT_NE(finished.output.find("one/results.json: files[0].claims[0].verdict: error: "
                                 "'surely' is not known here\n"
                                 "  hint: one of proven refuted conditional undecided"),
            std::string::npos)
      << finished.output;
}

TEST_F(Report, folders_of_results_and_files_are_not_mixed) {
  EXPECT_EQ(seamproof("report one a.seam --out two").status, 64);
}

TEST_F(Report, without_results_a_folder_is_one_of_files) {
  EXPECT_EQ(seamproof("report . --out two").status, 0);
  EXPECT_EQ(in_folder("cmp one/report.tex two/report.tex").status, 0);
}

}  // namespace
}  // namespace seam::test
