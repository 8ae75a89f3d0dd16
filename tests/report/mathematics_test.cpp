// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/mathematics.h"

#include <gtest/gtest.h>

namespace seam::report {
namespace {

TEST(Mathematics, ordinary_formulas_are_plain) {
  for (const char* latex :
       {"", "x_1^2 + \\frac{\\sqrt{5} - 1}{2} \\le 0", "\\left( a, b \\right]", "\\{1\\}",
        "\\begin{pmatrix} a & b \\\\ c & d \\end{pmatrix}",
        "\\begin{array}{cc} 1 & 2 \\end{array}",
        "\\operatorname{gauss}(p)\\quad\\text{for all }u",
        "\\left\\{ x \\middle| y \\right\\}"})
    EXPECT_TRUE(is_plain_mathematics(latex)) << latex;
}

TEST(Mathematics, what_could_do_more_than_be_printed_is_not_plain) {
  for (const char* latex :
       {"\\input{/etc/passwd}", "\\write18{ls}", "\\def\\x{1}", "\\csname x\\endcsname",
        "\\catcode`\\%=12", "^^5cinput", "x $ y", "% x", "#1", "\\begin{document}",
        "\\begin{verbatim}\\end{verbatim}", "\\", "é", "\x01"})
    EXPECT_FALSE(is_plain_mathematics(latex)) << latex;
}

TEST(Mathematics, what_is_not_nested_properly_is_not_plain) {
  for (const char* latex :
       {"{", "}", "\\frac{1}{2", "\\left( x", "x \\right)", "{\\left( } \\right)",
        "\\begin{pmatrix} a", "\\begin{pmatrix} a \\end{bmatrix}", "a & b", "\\middle| x"})
    EXPECT_FALSE(is_plain_mathematics(latex)) << latex;
}

TEST(Mathematics, a_formula_that_is_not_plain_is_printed_as_text) {
  EXPECT_EQ(mathematics("x + 1"), "x + 1");
  EXPECT_EQ(mathematics("\\x$"), "\\text{\\textbackslash{}x\\$}");
}

}  // namespace
}  // namespace seam::report
