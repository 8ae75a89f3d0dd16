// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/latex.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "report/figure.h"
#include "report/glossary.h"
#include "report/latex_errata.h"
#include "report/latex_table.h"
#include "report/pdf.h"
#include "sample.h"

namespace seam::report {
namespace {

namespace fs = std::filesystem;

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string latex_of(const ClaimRun& claim) {
  FileRun file;
  file.file = "a.seam";
  file.items = {claim};
  return latex({"seamproof 0.1.0", {file}});
}

TEST(Latex, holds_no_times) {
  report::Run late = sample();
  for (ItemRun& item : late.files[0].items)
    if (auto* claim = std::get_if<ClaimRun>(&item)) claim->seconds += 1;
  EXPECT_EQ(latex(late), latex(sample()));
}

TEST(Latex, the_verdict_is_a_word_beside_its_mark) {
  ClaimRun claim;
  claim.id = "a";
  claim.printed.verdict = Verdict::proven;
  EXPECT_TRUE(holds(latex_of(claim), "\\SeamClaim{proven}"));
}

TEST(Latex, a_refuted_claim_is_listed_under_errata_and_a_proven_one_is_not) {
  ClaimRun claim;
  claim.id = "a";
  claim.printed.verdict = Verdict::proven;
  EXPECT_FALSE(holds(latex_of(claim), "Errata"));
  claim.printed.verdict = Verdict::refuted;
  EXPECT_TRUE(holds(latex_of(claim), "Refuted, without a proven correction"));
  claim.corrected.emplace().verdict = Verdict::proven;
  EXPECT_TRUE(holds(latex_of(claim), "Errata"));
}

ClaimRun refuted_at(const std::string& id, const std::string& at) {
  ClaimRun claim;
  claim.id = id;
  claim.at = at;
  claim.printed.verdict = claim.expected = Verdict::refuted;
  claim.printed.latex = "x = 1";
  return claim;
}

TEST(Errata, what_stands_at_one_place_of_the_paper_stands_together) {
  FileRun file;
  for (const auto& [id, at] : {std::pair("a", "p. 4"), {"b", "p. 2"}, {"c", "p. 4"}})
    file.items.push_back(refuted_at(id, at));
  const std::string errata = latex_errata(file);
  const auto place = [&](const std::string& part) { return errata.find(part); };
  EXPECT_LT(place("\\SeamPlace{p. 4}"), place("\\textbf{a}"));
  EXPECT_LT(place("{a}"), place("{c}"));
  EXPECT_LT(place("{c}"), place("\\SeamPlace{p. 2}"));
  EXPECT_LT(place("\\SeamPlace{p. 2}"), place("{b}"));
}

TEST(Errata, should_read_is_said_of_a_proven_correction_and_of_certified_digits_alone) {
  FileRun file;
  ClaimRun claim = refuted_at("a", "p. 4");
  const auto errata = [&] {
    file.items = {claim};
    return latex_errata(file);
  };
  EXPECT_FALSE(holds(errata(), "should read"));
  claim.corrected.emplace().verdict = Verdict::undecided;
  EXPECT_FALSE(holds(errata(), "should read"));
  EXPECT_TRUE(holds(errata(), "\\SeamVerdict{undecided}"));
  claim.corrected->verdict = Verdict::proven;
  EXPECT_TRUE(holds(errata(), "should read"));
  claim.corrected.reset();
  claim.true_digits = "0.286";
  EXPECT_TRUE(holds(errata(), "{should read}\n0.286"));
}

TEST(Table, a_cell_that_is_wrong_has_the_true_digits_below_what_is_printed) {
  TableRun table{"t", "", "", {"one"}, {}, {}};
  table.rows = {{"row", "x", {refuted_at("t.row.one", "")}, {"0.287"}}};
  table.rows[0].cells[0].true_digits = "0.286";
  EXPECT_TRUE(holds(latex_table(table), "\\SeamCell{refuted}{0.287}{0.286}"));
}

TEST(Latex, the_libraries_at_work_are_named_with_their_versions) {
  EXPECT_TRUE(holds(latex({"seamproof 0.1.0", {FileRun{}}, {"GiNaC 1.8.6"}}), "GiNaC 1.8.6"));
}

TEST(Latex, obligations_that_are_alike_are_counted) {
  ClaimRun claim;
  claim.printed.obligations.resize(
      30, {"equal planes", "zero", "", "", false, ObligationRun::Status::holds, "normal form"});
  claim.printed.obligations.push_back(
      {"equal planes", "zero", "", "", false, ObligationRun::Status::fails, "a point"});
  const std::string report = latex_of(claim);
  EXPECT_TRUE(holds(report, "30 of this kind"));
  EXPECT_TRUE(holds(report, "\\SeamObligation{fails}{equal planes}{a point}"));
}

TEST(Latex, a_run_with_an_alarm_does_not_say_that_all_was_accepted) {
  ClaimRun claim;
  EXPECT_TRUE(holds(latex_of(claim), "was accepted by the independent checker"));
  claim.printed.alarm = "objection";
  EXPECT_FALSE(holds(latex_of(claim), "was accepted by the independent checker"));
}

TEST(Latex, the_glossary_has_the_predicates_used_and_no_others) {
  const auto entries = glossary({"closed", "G1", "closed", "my_own"});
  ASSERT_EQ(entries.size(), 2u);
  EXPECT_EQ(entries[0].predicate, "G1");
  EXPECT_EQ(entries[1].predicate, "closed");
}

TEST(Latex, a_picture_of_a_closed_surface_shows_the_facets_that_look_at_the_eye) {
  FigureRun figure;
  figure.closed = true;
  figure.points = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  figure.normals = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  figure.triangles = {{0, 1, 2}};
  EXPECT_TRUE(holds(picture(figure), "\\SeamFacet "));
  figure.triangles = {{1, 0, 2}};
  EXPECT_EQ(picture(figure), "");
}

// The sample holds hostile text and formulas wider and longer than a page.
TEST(Latex, the_sample_is_typeset_and_gives_the_same_bytes_again) {
  const fs::path folder = fs::path(testing::TempDir()) / "seamproof_latex_test";
  fs::remove_all(folder);
  ASSERT_FALSE(write_file(folder / "report.tex", latex(sample())));
  const auto error = typeset(folder / "report.tex");
  ASSERT_FALSE(error) << error->message;
  const std::string first = bytes_of(folder / "report.pdf");
  EXPECT_TRUE(first.starts_with("%PDF"));
  ASSERT_FALSE(typeset(folder / "report.tex"));
  EXPECT_EQ(bytes_of(folder / "report.pdf"), first);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 2);
  fs::remove_all(folder);
}

TEST(Latex, a_document_that_is_wrong_gives_the_complaint_and_keeps_the_earlier_report) {
  const fs::path folder = fs::path(testing::TempDir()) / "seamproof_latex_wrong";
  ASSERT_FALSE(write_file(folder / "report.pdf", "earlier"));
  ASSERT_FALSE(write_file(folder / "report.tex",
                          "\\documentclass{article}\\begin{document}\n\\nonsense\n"));
  const auto error = typeset(folder / "report.tex");
  ASSERT_TRUE(error);
  EXPECT_TRUE(holds(error->message, "Undefined control sequence")) << error->message;
  EXPECT_EQ(bytes_of(folder / "report.pdf"), "earlier");
  fs::remove_all(folder);
}

}  // namespace
}  // namespace seam::report
