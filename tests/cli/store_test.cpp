// SPDX-License-Identifier: GPL-3.0-or-later
// What is kept from one run to the next, and that it cannot do harm.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "programs.h"

namespace seam::test {
namespace {

class Kept : public Programs {
 protected:
  Kept() {
    write("surface.seam",
          "param x in [0, 1]\n"
          "claim a: x*(1 - x) <= 1/4\n"
          "claim b: x^2 + 1 > 0\n"
          "claim c: x*(1 - x) < 1/4\n    corrected: x*(1 - x) < 1/3\n");
  }
  Finished verify(const std::string& words) const {
    return seamproof("verify surface.seam --cache store " + words);
  }
  std::vector<fs::path> entries() const {
    std::vector<fs::path> all;
    for (const auto& entry : fs::recursive_directory_iterator(folder_ / "store"))
      if (entry.is_regular_file()) all.push_back(entry.path());
    std::ranges::sort(all);
    return all;
  }
  // With the store as it is now, all comes out as without one.
  void expect_no_harm() const {
    ASSERT_EQ(seamproof("verify surface.seam --no-cache --out without").status, 0);
    fs::remove_all(folder_ / "with");
    const Finished finished = verify("--out with");
    EXPECT_EQ(finished.status, 0) << finished.output;
    EXPECT_EQ(in_folder("diff -r without with").output, "");
  }
  static std::string bytes(const fs::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

TEST_F(Kept, a_store_changes_no_byte_of_what_is_written) {
  expect_no_harm();
  EXPECT_EQ(entries().size(), 4u);
  expect_no_harm();
}

TEST_F(Kept, what_was_decided_is_not_searched_for_again) {
  ASSERT_EQ(verify("-v").status, 0);
  const std::string again = verify("-v").output;
  EXPECT_NE(again.find("stored"), std::string::npos) << again;
  EXPECT_EQ(again.find("searched"), std::string::npos) << again;
}

TEST_F(Kept, a_changed_claim_alone_is_searched_for) {
  ASSERT_EQ(verify("").status, 0);
  in_folder("sed -i 's/x^2 + 1/x^2 + 2/' surface.seam");
  ASSERT_EQ(verify("").status, 0);
  EXPECT_EQ(entries().size(), 5u);
}

TEST_F(Kept, another_effort_has_other_entries) {
  ASSERT_EQ(verify("").status, 0);
  ASSERT_EQ(verify("--effort 30000").status, 0);
  EXPECT_EQ(entries().size(), 8u);
}

TEST_F(Kept, a_truncated_entry_is_none) {
  ASSERT_EQ(verify("").status, 0);
  for (const auto& entry : entries()) fs::resize_file(entry, fs::file_size(entry) / 2);
  expect_no_harm();
}

TEST_F(Kept, an_empty_entry_is_none) {
  ASSERT_EQ(verify("").status, 0);
  for (const auto& entry : entries()) fs::resize_file(entry, 0);
  expect_no_harm();
}

TEST_F(Kept, an_entry_about_another_statement_is_none) {
  ASSERT_EQ(verify("").status, 0);
  const auto all = entries();
  const std::string first = bytes(all[0]);
  for (std::size_t i = 0; i + 1 < all.size(); ++i) std::ofstream(all[i]) << bytes(all[i + 1]);
  std::ofstream(all.back()) << first;
  expect_no_harm();
}

TEST_F(Kept, forged_evidence_is_judged_and_searched_for_anew) {
  ASSERT_EQ(verify("").status, 0);
  // Whatever was found: now it says that a computation shows it, under a fitting hash.
  int forged = 0;
  for (const auto& entry : entries()) {
    std::string text = bytes(entry).substr(65);
    const std::size_t at = text.find("\"proofs\":");
    ASSERT_NE(at, std::string::npos) << text;
    const std::size_t end = text.rfind(']');
    text = text.substr(0, at) + "\"proofs\": [\"computation\"" + text.substr(end);
    write("text", text);
    write(fs::relative(entry, folder_).string(),
          in_folder("sha256sum < text").output.substr(0, 64) + "\n" + text);
    ++forged;
  }
  EXPECT_EQ(forged, 4);
  expect_no_harm();
}

TEST_F(Kept, a_store_that_cannot_be_written_is_no_error) {
  EXPECT_EQ(seamproof("verify surface.seam --cache surface.seam/store").status, 0);
  EXPECT_EQ(seamproof("verify surface.seam --cache /dev/null").status, 0);
}

TEST_F(Kept, what_ran_out_of_time_is_not_kept) {
  const std::string words = "verify hard.seam --cache store --effort 1000000000 --timeout 1";
  const Finished finished = seamproof(words);
  EXPECT_EQ(finished.status, 2);
  EXPECT_NE(finished.output.find("time: "), std::string::npos) << finished.output;
  EXPECT_EQ(entries().size(), 2u);
}

TEST_F(Kept, what_ran_out_of_memory_is_not_kept_and_harms_nothing_else) {
  const std::string words =
      "verify hard.seam --cache store --effort 1000000000 --timeout 100 --memory 20";
  const Finished finished = seamproof(words);
  EXPECT_EQ(finished.status, 2);
  EXPECT_NE(finished.output.find("memory: "), std::string::npos) << finished.output;
  EXPECT_NE(finished.output.find("2 proven"), std::string::npos) << finished.output;
  EXPECT_EQ(entries().size(), 2u);
}

TEST_F(Kept, an_interrupted_run_keeps_what_was_done_and_says_so) {
  for (const auto& [signal, status] : {std::pair{"INT", 130}, std::pair{"TERM", 143}}) {
    fs::remove_all(folder_ / "store");
    const Finished finished = in_folder(
        "{ " + quoted(SEAMPROOF) +
        " verify hard.seam --cache store --effort 1000000000 --jobs 2 --out out & pid=$!; "
        "for i in $(seq 200); do "
        "[ \"$(find store -name '*.json' 2>/dev/null | wc -l)\" = 2 ] && break; sleep 0.05; "
        "done; "
        "kill -" +
        signal + " $pid; wait $pid; }");
    EXPECT_EQ(finished.status, status) << finished.output;
    EXPECT_NE(finished.output.find("1 of 3 statements are left; 2 are in the store"),
              std::string::npos)
        << finished.output;
    EXPECT_FALSE(fs::exists(folder_ / "out"));
  }
}

TEST_F(Kept, a_run_that_is_killed_at_any_moment_ends_with_the_same_bytes_when_run_again) {
  ASSERT_EQ(seamproof("verify surface.seam --no-cache --out without").status, 0);
  for (int moment = 0; moment < 12; ++moment) {
    const Finished killed =
        in_folder("timeout -s KILL 0." + std::to_string(100 + 7 * moment).substr(0, 3) + " " +
                  quoted(SEAMPROOF) + " verify surface.seam --cache store --out with; true");
    ASSERT_EQ(killed.status, 0);
    // What is there is whole.
    if (fs::exists(folder_ / "with" / "results.json")) {
      EXPECT_EQ(in_folder("cmp without/results.json with/results.json").output, "");
    }
  }
  const Finished finished = verify("--out with");
  EXPECT_EQ(finished.status, 0);
  EXPECT_EQ(in_folder("diff -r without with").output, "");
}

TEST_F(Programs, pages_and_fragments_of_other_results_do_not_stay_beside_new_ones) {
  write("a.seam", "claim a: 1 = 1\nclaim gone: 2 = 2\n");
  EXPECT_EQ(seamproof("verify a.seam --out o --html --fragments --quiet").status, 0);
  EXPECT_EQ(seamproof("verify a.seam --out o --quiet").status, 0);
  EXPECT_TRUE(fs::exists(folder_ / "o/report.html"));  // the results are the same
  write("a.seam", "claim a: 1 = 2\n");
  EXPECT_EQ(seamproof("verify a.seam --out o --quiet").status, 1);
  EXPECT_FALSE(fs::exists(folder_ / "o/report.html"));
  EXPECT_FALSE(fs::exists(folder_ / "o/fragments/a.tex"));
  EXPECT_FALSE(fs::exists(folder_ / "o/certificates/gone.json"));
}

TEST_F(Programs, certificates_of_claims_that_are_gone_go_too) {
  write("two.seam", "claim a: 1 + 1 = 2\nclaim b: 1 + 2 = 3\n");
  ASSERT_EQ(seamproof("verify two.seam --out out").status, 0);
  write("out/certificates/mine.json", "{}");
  ASSERT_EQ(seamproof("verify two.seam --out out --claim a").status, 0);
  EXPECT_TRUE(fs::exists(folder_ / "out/certificates/b.json"));
  write("two.seam", "claim a: 1 + 1 = 2\n");
  ASSERT_EQ(seamproof("verify two.seam --out out").status, 0);
  EXPECT_TRUE(fs::exists(folder_ / "out/certificates/a.json"));
  EXPECT_FALSE(fs::exists(folder_ / "out/certificates/b.json"));
  EXPECT_TRUE(fs::exists(folder_ / "out/certificates/mine.json"));
}

TEST_F(Programs, what_a_killed_run_left_half_written_is_removed) {
  ASSERT_EQ(seamproof("verify right.seam --out out").status, 0);
  write("out/report.tex.unfinished-99999999", "half");
  ASSERT_EQ(seamproof("verify right.seam --out out").status, 0);
  EXPECT_FALSE(fs::exists(folder_ / "out/report.tex.unfinished-99999999"));
}

}  // namespace
}  // namespace seam::test
