// SPDX-License-Identifier: GPL-3.0-or-later
// Where printed digits are refuted the report has the true ones, if the checker confirms them.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "process.h"

namespace seam::test {
namespace {

namespace fs = std::filesystem;

// The LaTeX report of a file.
std::string report_of(const std::string& claims) {
  const fs::path folder = fs::path(testing::TempDir()) /
                          (std::string("seamproof_true_digits_") +
                           testing::UnitTest::GetInstance()->current_test_info()->name());
  fs::remove_all(folder);
  fs::create_directories(folder);
  std::ofstream(folder / "a.seam") << claims;
  run("cd " + quoted(folder.string()) + " && " + quoted(SEAMPROOF) + " verify a.seam --out .");
  std::ifstream file(folder / "report.tex");
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

bool has_true_digits(const std::string& report, const std::string& digits) {
  return report.find("\\SeamLine{true digits}{" + digits + "}") != std::string::npos;
}

TEST(TrueDigits, they_are_as_many_as_are_printed) {
  EXPECT_TRUE(has_true_digits(report_of("claim a: pi ~ 3.1415\n"), "3.1416"));
  EXPECT_TRUE(has_true_digits(
      report_of("claim a: 0 - 2/7 ~ -0.28\n    corrected: 0 - 2/7 ~ -0.2857\n"), "-{}0.2857"));
}

TEST(TrueDigits, of_a_cell_they_belong_to_its_column) {
  const std::string report =
      report_of("table t for k in 1..3: \"row\" sqrt(k + 1) ~ 1.41, 1.74, 2.00\n");
  EXPECT_NE(report.find("\\SeamCell{refuted}{1.74}{1.73}"), std::string::npos);
  EXPECT_NE(report.find("\\SeamCell{proven}{2.00}{}"), std::string::npos);
}

TEST(TrueDigits, digits_that_are_cut_off_are_not_rounded) {
  EXPECT_TRUE(
      has_true_digits(report_of("claim a: sqrt(3) ~ 1.74 truncated\n"), "1.73\\ldots{}"));
}

TEST(TrueDigits, of_an_extremum_they_are_certified_too) {
  EXPECT_TRUE(has_true_digits(
      report_of("claim a: max(u*(1 - u)*(2 - u) for u in [0, 1]) ~ 0.384\n"), "0.385"));
}

TEST(TrueDigits, of_a_correction_that_speaks_of_something_else_they_are_not_taken) {
  EXPECT_TRUE(
      has_true_digits(report_of("claim a: 1/3 ~ 0.34\n    corrected: 2/3 ~ 0.67\n"), "0.33"));
}

TEST(TrueDigits, a_claim_that_holds_has_none) {
  EXPECT_EQ(report_of("claim a: pi ~ 3.14\n").find("{true digits}"), std::string::npos);
}

}  // namespace
}  // namespace seam::test
