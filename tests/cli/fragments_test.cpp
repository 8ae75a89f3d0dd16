// SPDX-License-Identifier: GPL-3.0-or-later
// A paper that shows parts of a report is typeset without the program.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "process.h"

namespace seam::test {
namespace {

namespace fs = std::filesystem;

class Fragments : public testing::Test {
 protected:
  Fragments() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    // A letter, a sign, a name that old encodings lack; an id with what TeX takes for its own.
    std::ofstream(folder_ / "a.seam")
        << "# \"α ≤ 1\", đ, Ą, 100 % of #1 & ~\n"
           "claim first_one: for all u: u^2 >= 0\n"
           "claim second:b \"Bézier\" at \"§2\": pi ~ 3.1415\n"
           "table t \"roots\" for k in 1..2: \"√k\" sqrt(k) ~ 1.00, 1.42\n"
           "figure \"cube\": cube\n"
           "ask half: 1/2\n";
    in_folder(quoted(SEAMPROOF) + " verify a.seam --out out --fragments");
    fs::create_directories(folder_ / "paper");
    fs::rename(folder_ / "out/fragments", folder_ / "paper/fragments");
    fs::rename(folder_ / "paper/fragments/seamproof.sty", folder_ / "paper/seamproof.sty");
  }
  ~Fragments() override { fs::remove_all(folder_); }

  Finished in_folder(const std::string& line) const {
    return run("cd " + quoted(folder_.string()) + " && " + line);
  }

  // A paper of a class, with a line that brings the style.
  void write(const std::string& document_class, const std::string& style) const {
    std::ofstream(folder_ / "paper/paper.tex")
        << "\\documentclass{" << document_class << "}\n"
        << style
        << "\n\\input{fragments/seamproof-status}\n\\begin{document}\n"
           "\\section{Results \\spstatus{first_one}}\n"
           "$x = \\spval{half}{0.5}$, \\spval{half}{5\\times10^{-1}} "
           "\\spstatus{second:b}{refuted}\n"
           "\\input{fragments/first_one}\n\\input{fragments/second=b}\n"
           "\\input{fragments/tables/t}\n\\end{document}\n";
  }

  fs::path folder_ = fs::path(testing::TempDir()) /
                     (std::string("seamproof_") +
                      testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(Fragments, a_paper_of_any_class_takes_them_by_usepackage_and_by_input) {
  for (const char* document_class : {"article", "amsart", "elsarticle"}) {
    if (run("kpsewhich " + std::string(document_class) + ".cls").status != 0) continue;
    for (const char* style : {"\\usepackage{seamproof}", "\\input{seamproof.sty}"}) {
      write(document_class, style);
      const Finished finished =
          in_folder("cd paper && pdflatex -interaction=nonstopmode -halt-on-error paper.tex");
      EXPECT_EQ(finished.status, 0) << document_class << style << finished.output;
      EXPECT_EQ(finished.output.find("no status of"), std::string::npos) << finished.output;
    }
  }
}

TEST_F(Fragments, the_text_of_the_paper_has_the_values_and_the_verdicts) {
  write("article", "\\input{seamproof.sty}");
  const Finished text = in_folder(
      "cd paper && pdflatex -interaction=nonstopmode paper.tex >/dev/null && pdftotext "
      "paper.pdf -");
  for (const char* part : {"Results", "proven", "x = 0.5", "refuted", "second:b", "true: 1.41"})
    EXPECT_NE(text.output.find(part), std::string::npos) << part << text.output;
}

TEST_F(Fragments, a_figure_needs_tikz_and_nothing_else) {
  std::ofstream(folder_ / "paper/paper.tex")
      << "\\documentclass{article}\\usepackage{tikz}\\input{seamproof.sty}\\begin{document}\n"
         "\\input{fragments/figures/cube}\\end{document}\n";
  const Finished finished =
      in_folder("cd paper && pdflatex -interaction=nonstopmode -halt-on-error paper.tex");
  EXPECT_EQ(finished.status, 0) << finished.output;
}

TEST_F(Fragments, a_web_page_is_made_of_the_paper_without_a_complaint) {
  if (run("command -v latexml").status != 0) GTEST_SKIP() << "latexml is not there";
  write("article", "\\input{seamproof.sty}");
  const Finished finished = in_folder("cd paper && latexml --dest=paper.xml paper.tex");
  EXPECT_NE(finished.output.find("No obvious problems"), std::string::npos) << finished.output;
}

TEST_F(Fragments, check_tex_reads_a_paper_with_them) {
  write("article", "\\input{seamproof.sty}");
  const Finished finished = in_folder(quoted(SEAMPROOF) + " check-tex paper/paper.tex a.seam");
  EXPECT_EQ(finished.status, 0) << finished.output;
  EXPECT_NE(finished.output.find("4 printed, 4 right"), std::string::npos) << finished.output;
}

TEST_F(Fragments, they_need_a_folder_to_go_to) {
  EXPECT_EQ(in_folder(quoted(SEAMPROOF) + " verify a.seam --fragments").status, 64);
}

TEST(ReportPdf, equal_input_gives_equal_bytes_in_any_folder_at_any_time) {
  const fs::path folder = fs::path(testing::TempDir()) / "seamproof_pdf";
  fs::remove_all(folder);
  fs::create_directories(folder / "one");
  fs::create_directories(folder / "two/deeper");
  const std::string claims = "claim a: for all u: u^2 >= 0\nfigure \"cube\": cube\n";
  std::ofstream(folder / "one/a.seam") << claims;
  std::ofstream(folder / "two/deeper/a.seam") << claims;
  const std::string verify = quoted(SEAMPROOF) + " verify a.seam --pdf --out ";
  run("cd " + quoted((folder / "one").string()) + " && TZ=Asia/Tokyo " + verify + "out");
  run("cd " + quoted((folder / "two/deeper").string()) + " && sleep 1.1 && TZ=America/Lima " +
      verify + "reports/out");
  const Finished compared = run("cd " + quoted(folder.string()) +
                                " && test -s one/out/report.pdf && "
                                "cmp one/out/report.pdf two/deeper/reports/out/report.pdf");
  EXPECT_EQ(compared.status, 0) << compared.output;
  fs::remove_all(folder);
}

}  // namespace
}  // namespace seam::test
