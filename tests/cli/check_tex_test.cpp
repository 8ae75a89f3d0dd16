// SPDX-License-Identifier: GPL-3.0-or-later
// Every value that a paper prints with \spval is proven to be printed right, or named.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "process.h"

namespace seam::test {
namespace {

namespace fs = std::filesystem;

class CheckTex : public testing::Test {
 protected:
  CheckTex() {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "paper/parts");
    write("a.seam",
          "let third = 1/3\nlet minus = 0 - 2/7\nlet large = 12345/10\nlet small = 1/700\n"
          "let tie = 15/100\n"
          "claim half: 1/2 = 2/4\nclaim wrong: pi ~ 3.1415\n    corrected: pi ~ 3.1416\n"
          "claim everywhere: for all u: u^2 >= 0\n"
          "table t \"roots\" for k in 1..2 labelled \"one\", \"two\": \"root\" sqrt(k) ~ 1.00, "
          "1.41\n"
          "ask most: max(u*(1 - u)*(2 - u) for u in [0, 1])\n");
  }
  ~CheckTex() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }
  // What is said of a paper with this text.
  Finished check(const std::string& text) const {
    write("paper/paper.tex", text);
    return run("cd " + quoted(folder_.string()) + " && " + quoted(SEAMPROOF) +
               " check-tex paper/paper.tex a.seam");
  }
  int status(const std::string& text) const { return check(text).status; }

  fs::path folder_ = fs::path(testing::TempDir()) /
                     (std::string("seamproof_") +
                      testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(CheckTex, a_right_value_is_right_and_its_wrong_twin_is_wrong) {
  for (const auto& [right, wrong] : {
           std::pair("{third}{0.333}", "{third}{0.334}"),
           {"{third}{.3333}", "{third}{.3334}"},
           {"{minus}{-0.2857}", "{minus}{0.2857}"},
           {"{minus}{−0.2857}", "{minus}{−0.2858}"},
           {"{minus}{{-}0.2857}", "{minus}{{-}0.2856}"},
           {"{large}{1.23\\times10^{3}}", "{large}{1.24\\times10^{3}}"},
           {"{large}{1.2\\cdot 10^3}", "{large}{1.3\\cdot 10^3}"},
           {"{large}{1234.5}", "{large}{1234.4}"},
           {"{large}{1\\,234.5}", "{large}{1\\,234.6}"},
           {"{large}{12345e-1}", "{large}{12346e-1}"},
           {"{small}{1.43\\times 10^{-3}}", "{small}{1.42\\times 10^{-3}}"},
           {"{small}{\\num{1.43e-3}}", "{small}{\\num{1.43e-4}}"},
           {"{small}{0.0014}", "{small}{0.00140}"},
           {"{third}{{0.{33}3}}", "{third}{{0.{33}4}}"},
           {"{third}{0.33\\ldots}", "{third}{0.34\\ldots}"},
           {"{wrong}{3.1416}", "{wrong}{3.1415}"},
           {"{wrong}{3.1415\\dots}", "{wrong}{3.1416\\dots}"},
           {"{half.right}{0.5}", "{half.right}{0.4}"},
           {"{t.root.two}{1.414}", "{t.root.two}{1.415}"},
           {"{most}{0.3849}", "{most}{0.3848}"},
       }) {
    EXPECT_EQ(status("\\spval" + std::string(right)), 0) << right;
    EXPECT_EQ(status("\\spval" + std::string(wrong)), 1) << wrong;
  }
}

TEST_F(CheckTex, at_a_tie_either_neighbour_is_right_and_no_other) {
  EXPECT_EQ(status("\\spval{tie}{0.1} \\spval{tie}{0.2}"), 0);
  EXPECT_EQ(status("\\spval{tie}{0.3}"), 1);
  EXPECT_EQ(status("\\spval{tie}{0.0}"), 1);
}

TEST_F(CheckTex, a_wrong_value_is_named_with_its_place_and_the_true_digits) {
  const Finished finished = check("\n\n  \\spval{third}{0.334}\n");
  EXPECT_NE(finished.output.find("paper/paper.tex:3:3  third  0.334  (true digits: 0.333)"),
            std::string::npos)
      << finished.output;
}

TEST_F(CheckTex, what_TeX_does_not_set_is_not_read) {
  EXPECT_EQ(status("% \\spval{third}{1}\n\\verb|\\spval{third}{1}|\n"
                   "\\begin{verbatim}\n\\spval{third}{1}\n\\end{verbatim}\n"
                   "\\iffalse \\ifx\\a\\b \\fi \\spval{third}{1} \\fi\n"
                   "\\spval{third}{0.% 9}\n333}\n\\end{document} \\spval{third}{1}"),
            0);
  EXPECT_EQ(status("\\% \\spval{third}{1}"), 1);
  EXPECT_EQ(status("\\\\% \\spval{third}{1}"), 0);
  EXPECT_EQ(status("\\verb%% \\spval{third}{1}"), 1);
  EXPECT_EQ(status("\\iffalse\\else\\spval{third}{1}\\fi"), 1);
}

// Each of these papers prints a wrong value.
TEST_F(CheckTex, what_TeX_may_set_is_not_passed_over) {
  for (const char* paper :
       {"\\let\\ifdraft\\iffalse \\ifdraft x\\fi \\spval{third}{1}",
        "\\def\\draftfalse{\\let\\ifdraft=\\iffalse}\\spval{third}{1}",
        "\\ifx\\ifdraft\\iffalse\\fi \\spval{third}{1}",
        "\\href{https://a.b/c%20d}{e} \\spval{third}{1}", "\\url{a%b}, \\spval{third}{1}",
        "\\ifdefined\\nothing\\endinput\\fi \\spval{third}{1}",
        "\\newcommand{\\finish}{\\end{document}}\\spval{third}{1}",
        "\\newcommand{\\code}{\\begin{verbatim}}\\spval{third}{1}",
        "\\iffalse \\ifthenelse{a}{b}{c} \\fi \\spval{third}{1}",
        "\\verb |a|\\spval{third}{1} b", "\\lstinline{50 % of} \\spval{third}{1}",
        "\\begin{filecontents*}{v.tex}\\spval{third}{1}\\end{filecontents*}\\input{v}",
        "% a comment\rthe value \\spval{third}{1}\r"})
    EXPECT_EQ(status(paper), 1) << paper;
  EXPECT_EQ(status("\\newif\\ifdraft\\iffalse\\ifdraft a\\fi \\spval{third}{1}\\fi"), 0);
}

TEST_F(CheckTex, a_part_that_is_a_document_ends_only_itself) {
  write("paper/part.tex", "\\begin{document}\\spval{third}{0.3}\\end{document}");
  EXPECT_EQ(status("\\subfile{part} \\spval{third}{1}"), 1);
}

TEST_F(CheckTex, imported_files_input_from_their_own_folder) {
  write("paper/parts/one.tex", "\\input{values}");
  write("paper/parts/values.tex", "\\spval{third}{1}");
  write("paper/values.tex", "\\spval{third}{0.3}");
  EXPECT_EQ(status("\\import{parts/}{one}"), 1);
  EXPECT_EQ(status("\\import{parts/}{one}\\input{values}"), 1);
}

TEST_F(CheckTex, a_number_that_goes_on_outside_its_braces_is_refused) {
  for (const char* paper :
       {"$x = -\\spval{third}{0.3}$", "1\\spval{third}{0.3}", "\\spval{third}{0.3}3",
        "\\spval{third}{0.3}\\times10^{3}", "\\spval{third}{0.3}.5"})
    EXPECT_EQ(status(paper), 65) << paper;
  EXPECT_EQ(status("$x - \\spval{third}{0.3}$ and $2\\times\\spval{third}{0.3}$."), 0);
}

TEST_F(CheckTex, what_the_paper_inputs_is_read_once_and_nothing_above_its_folder) {
  write("paper/parts/one.tex", "\\input{parts/two} \\input{paper} \\spval{third}{0.3}");
  write("paper/parts/two.tex", "\\spval{third}{0.4}");
  const Finished finished = check("\\input{parts/one}\\include{parts/two}");
  EXPECT_EQ(finished.status, 1);
  EXPECT_NE(finished.output.find("paper/parts/two.tex:1:1  third  0.4"), std::string::npos);
  EXPECT_NE(finished.output.find("2 printed, 1 right, 1 wrong"), std::string::npos)
      << finished.output;

  EXPECT_EQ(status("\\import{parts/}{two}"), 1);
  EXPECT_EQ(status("\\InputIfFileExists{parts/two}{}{}"), 1);

  write("above.tex", "\\spval{third}{0.4}");
  const Finished above = check("\\input{../above} \\input ../above \\spval{third}{0.3}");
  EXPECT_EQ(above.status, 0);
  EXPECT_NE(above.output.find("not read: '../above'"), std::string::npos) << above.output;
}

TEST_F(CheckTex, an_unknown_id_gets_a_hint) {
  const Finished finished = check("\\spval{thrid}{0.3}");
  EXPECT_EQ(finished.status, 65);
  EXPECT_NE(finished.output.find("did you mean 'third'?"), std::string::npos);
  EXPECT_NE(check("\\spval{everywhere}{1}").output.find("compares no number"),
            std::string::npos);
}

TEST_F(CheckTex, what_is_no_number_is_named_and_not_passed_over) {
  for (const char* number : {"", "0,5", "1.2.3", "$0.5$", "x", "1.2\\pm0.1", "10^12",
                             "1\\times10^12", "\\timesx", "5\\%", "--5", "1\\times 9^{2}"}) {
    const Finished finished = check("\\spval{third}{" + std::string(number) + "}");
    EXPECT_EQ(finished.status, 65) << number;
    EXPECT_NE(finished.output.find("no number that can be checked"), std::string::npos)
        << finished.output;
  }
  EXPECT_EQ(status("\\spval{third}"), 65);
  EXPECT_EQ(status("\\newcommand{\\third}[1]{\\spval{third}{#1}}"), 65);
  EXPECT_EQ(status("\\newcommand{\\spval}[2]{#2}"), 0);
}

TEST_F(CheckTex, a_printed_verdict_is_that_of_the_claim) {
  EXPECT_EQ(status("\\spstatus{half}{proven} \\spstatus{wrong}{refuted}"), 0);
  EXPECT_EQ(status("\\spstatus{wrong}{proven}"), 1);
  EXPECT_EQ(status("\\spstatus{half}"), 65);
  write("paper/seamproof-status.tex",
        "\\SeamStatus{half}{proven}\n\\SeamStatus{wrong}{proven}\n");
  EXPECT_EQ(status("\\input{seamproof-status}\\spstatus{half}"), 0);
  EXPECT_EQ(status("\\input{seamproof-status}\\spstatus{wrong}"), 1);
  EXPECT_EQ(status("\\SeamStatus{wrong}{proven}\\spstatus{wrong}\\SeamStatus{wrong}{refuted}"),
            65);
}

TEST_F(CheckTex, files_that_are_not_there_or_wrong_have_their_exit_status) {
  const auto words = [&](const std::string& arguments) {
    return run("cd " + quoted(folder_.string()) + " && " + quoted(SEAMPROOF) + " check-tex " +
               arguments)
        .status;
  };
  EXPECT_EQ(words("none.tex a.seam"), 66);
  check("");
  EXPECT_EQ(words("paper/paper.tex none.seam"), 66);
  write("broken.seam", "claim a: 1 + = 2\n");
  EXPECT_EQ(words("paper/paper.tex broken.seam"), 65);
  EXPECT_EQ(words("paper/paper.tex"), 64);
}

}  // namespace
}  // namespace seam::test
