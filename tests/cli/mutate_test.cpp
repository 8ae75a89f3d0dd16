// SPDX-License-Identifier: GPL-3.0-or-later
// `seamproof mutate`: what is said of small changes.

#include <gtest/gtest.h>

#include "programs.h"

namespace seam::test {
namespace {

class Mutate : public Programs {
 protected:
  Mutate() {
    write("rule.seam",
          "param k in (0, 1)\nlet f(x) = k*x^2\nlet unused = 1/3\n"
          "claim rule: for all x: f(2*x) = 4*f(x)\n"
          "claim bound: for x in [0, 1]: f(x) <= 3*k\n");
  }
  Finished mutate(const std::string& words) const {
    return seamproof("mutate rule.seam --no-cache --quiet --json results.json " + words);
  }
};

TEST_F(Mutate, equal_seeds_give_equal_bytes_for_any_number_of_jobs) {
  const std::string command = "mutate rule.seam --no-cache --per-claim 8 --json - --quiet ";
  const Finished one = seamproof(command + "--jobs 1"), two = seamproof(command + "--jobs 2");
  EXPECT_EQ(one.status, 0) << one.output;
  EXPECT_EQ(one.output, two.output);
  EXPECT_NE(one.output, seamproof(command + "--jobs 1 --seed 2").output);
}

TEST_F(Mutate, what_survives_is_printed_before_and_after) {
  const Finished finished =
      seamproof("mutate rule.seam --no-cache --per-claim 40 --claim rule");
  EXPECT_EQ(finished.status, 0);
  EXPECT_NE(finished.output.find("      - k*x^2\n      + -k*x^2\n"
                                 "      another statement, still proven\n"),
            std::string::npos)
      << finished.output;
  EXPECT_EQ(finished.output.find("bound"), std::string::npos);
  EXPECT_EQ(finished.output.find("unused"), std::string::npos);
}

TEST_F(Mutate, decided_mutants_are_kept_with_certificates_that_the_checker_accepts) {
  EXPECT_EQ(mutate("--per-claim 10 --out kept").status, 0);
  const Finished judged = in_folder(std::string(SEAMPROOF_CHECK) + " kept");
  EXPECT_EQ(judged.status, 0) << judged.output;
  EXPECT_NE(judged.output.find(" 0 invalid"), std::string::npos) << judged.output;
}

TEST_F(Mutate, a_mutant_may_need_more_than_there_is) {
  write("rule.seam",
        "claim a: 2^(10^1) = 1024\nclaim b: count(vertices(truncate(cube, 1/4, 3))) = 648\n");
  const Finished finished = mutate("--per-claim 30 --timeout 1 --memory 300");
  EXPECT_EQ(finished.status, 0) << finished.output;
}

TEST_F(Mutate, a_file_with_errors_and_an_id_that_is_not_there_are_refused) {
  EXPECT_EQ(mutate("--claim nothing").status, 64);
  write("rule.seam", "claim a: unknown(1) = 1\n");
  const Finished finished = mutate("");
  EXPECT_EQ(finished.status, 65);
  EXPECT_NE(finished.output.find("rule.seam:1:10"), std::string::npos) << finished.output;
}

}  // namespace
}  // namespace seam::test
