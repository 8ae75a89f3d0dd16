// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/run.h"

#include <gtest/gtest.h>

namespace seam::report {
namespace {

ClaimRun claim(Verdict verdict, Verdict expected = Verdict::proven) {
  ClaimRun result;
  result.printed.verdict = verdict;
  result.expected = expected;
  return result;
}

ClaimRun corrected(Verdict printed, Verdict correction) {
  ClaimRun result = claim(printed, Verdict::refuted);
  result.corrected.emplace();
  result.corrected->verdict = correction;
  return result;
}

ClaimRun alarming() {
  ClaimRun result = claim(Verdict::undecided);
  result.printed.alarm = "the checker objects";
  return result;
}

int status(std::vector<ItemRun> items, bool allow_undecided = false) {
  FileRun file;
  file.items = std::move(items);
  return exit_status({"", {file}}, allow_undecided);
}

TEST(Run, a_correction_is_met_when_the_print_is_refuted_and_the_correction_proven) {
  EXPECT_TRUE(as_expected(corrected(Verdict::refuted, Verdict::proven)));
  EXPECT_FALSE(as_expected(corrected(Verdict::proven, Verdict::proven)));
  EXPECT_FALSE(as_expected(corrected(Verdict::refuted, Verdict::undecided)));
  EXPECT_FALSE(as_expected(corrected(Verdict::refuted, Verdict::refuted)));
  EXPECT_FALSE(as_expected(corrected(Verdict::undecided, Verdict::proven)));
}

TEST(Run, a_conditional_claim_is_not_a_proven_one) {
  EXPECT_FALSE(as_expected(claim(Verdict::conditional)));
}

TEST(Run, the_status_is_0_when_all_is_as_expected) {
  EXPECT_EQ(status({}), 0);
  EXPECT_EQ(status({claim(Verdict::proven), claim(Verdict::refuted, Verdict::refuted),
                    claim(Verdict::undecided, Verdict::undecided),
                    corrected(Verdict::refuted, Verdict::proven)}),
            0);
}

TEST(Run, a_decided_claim_that_differs_gives_1) {
  EXPECT_EQ(status({claim(Verdict::refuted)}), 1);
  EXPECT_EQ(status({claim(Verdict::proven, Verdict::refuted)}), 1);
  EXPECT_EQ(status({claim(Verdict::proven, Verdict::undecided)}), 1);
  EXPECT_EQ(status({corrected(Verdict::refuted, Verdict::refuted)}), 1);
}

TEST(Run, an_undecided_claim_gives_2_unless_that_is_allowed) {
  for (const ClaimRun& open : {claim(Verdict::undecided), claim(Verdict::conditional),
                               corrected(Verdict::refuted, Verdict::undecided)}) {
    EXPECT_EQ(status({open}), 2);
    EXPECT_EQ(status({open}, true), 0);
  }
}

TEST(Run, the_most_urgent_claim_gives_the_status) {
  EXPECT_EQ(status({claim(Verdict::undecided), claim(Verdict::refuted)}), 1);
  EXPECT_EQ(status({claim(Verdict::refuted), claim(Verdict::undecided)}), 1);
  EXPECT_EQ(status({alarming(), claim(Verdict::refuted), claim(Verdict::undecided)}), 3);
}

TEST(Run, an_alarm_counts_even_where_the_undecided_are_allowed) {
  EXPECT_EQ(status({alarming()}, true), 3);
}

TEST(Run, the_cells_of_a_table_are_claims) {
  TableRun table;
  table.rows.push_back({"", "", {claim(Verdict::proven), claim(Verdict::refuted)}});
  FileRun file;
  file.items = {claim(Verdict::proven), table, SectionRun{"1"}, claim(Verdict::undecided)};
  const Summary summary = summarize(file);
  EXPECT_EQ(summary.claims, 4);
  EXPECT_EQ(summary.proven, 2);
  EXPECT_EQ(summary.refuted, 1);
  EXPECT_EQ(summary.undecided, 1);
  EXPECT_EQ(summary.as_expected, 2);
}

}  // namespace
}  // namespace seam::report
