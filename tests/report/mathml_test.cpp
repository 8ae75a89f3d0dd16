// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/mathml.h"

#include <gtest/gtest.h>

#include <random>

#include "well_formed.h"

namespace seam::report {
namespace {

std::string of(std::string_view latex) {
  return mathml(latex).value_or("unknown");
}

TEST(MathML, letters_numbers_and_operators_are_told_apart) {
  EXPECT_EQ(of("2x"), "<math><mn>2</mn><mi>x</mi></math>");
  EXPECT_EQ(of("0.25-y"), "<math><mn>0.25</mn><mo>−</mo><mi>y</mi></math>");
  EXPECT_EQ(of("\\gamma"), "<math><mi>γ</mi></math>");
}

TEST(MathML, a_sign_in_front_of_a_number_is_told_from_one_between_two) {
  const std::string prefix = "<mo form=\"prefix\">−</mo>";
  EXPECT_NE(of("(-2,x)").find(prefix), std::string::npos);
  EXPECT_NE(of("(0,-2)").find(prefix), std::string::npos);
  EXPECT_NE(of("a\\le-2").find("<math><mo>−</mo>"), std::string::npos);
  EXPECT_NE(of("\\left(-2\\right)").find("<mrow><mo>−</mo>"), std::string::npos);
  EXPECT_EQ(of("(a)-b").find("prefix"), std::string::npos);
  EXPECT_NE(of("a\\allowbreak-b").find("<math><mo form=\"infix\">−</mo>"), std::string::npos);
}

TEST(MathML, the_name_of_a_function_stands_apart_from_what_it_is_multiplied_with) {
  const std::string thin = "<mspace width=\"0.17em\"/>";
  EXPECT_NE(of("3\\operatorname{f}(x)").find("<mn>3</mn>" + thin), std::string::npos);
  EXPECT_NE(of("\\sin x").find("</mi>" + thin + "<mi>x"), std::string::npos);
  EXPECT_EQ(of("\\sin(x)").find(thin), std::string::npos);
}

TEST(MathML, scripts_belong_to_what_stands_in_front_of_them) {
  EXPECT_EQ(of("{x}^{2}"),
            "<math><msup><mrow><mrow><mi>x</mi></mrow></mrow><mrow><mn>2</mn>"
            "</mrow></msup></math>");
  EXPECT_EQ(of("B_{1}''"),
            "<math><msubsup><mrow><mi>B</mi></mrow><mrow><mn>1</mn></mrow>"
            "<mrow><mo>′</mo><mo>′</mo></mrow></msubsup></math>");
}

TEST(MathML, limits_stand_below_and_above) {
  EXPECT_NE(of("\\sum_{i=1}^{n} i").find("<munderover>"), std::string::npos);
  EXPECT_NE(of("\\max_{u} f").find("<munder>"), std::string::npos);
}

TEST(MathML, a_line_may_end_behind_a_relation_but_not_in_a_fraction) {
  EXPECT_EQ(of("a = b"),
            "<math><mi>a</mi><mo form=\"infix\">=</mo></math><wbr/>"
            "<math><mi>b</mi></math>");
  EXPECT_EQ(of("\\frac{a = b}{c}").find("<wbr/>"), std::string::npos);
}

TEST(MathML, matrices_have_rows_and_cells) {
  const std::string matrix = of("\\begin{pmatrix} a & b \\\\ c & d \\end{pmatrix}");
  EXPECT_NE(matrix.find("<mtr><mtd><mi>a</mi></mtd><mtd><mi>b</mi></mtd></mtr>"),
            std::string::npos);
}

TEST(MathML, text_is_no_markup) {
  EXPECT_EQ(of("\\text{a\\&b \\textbackslash{}}"),
            "<math><mtext>a&amp;b\u00A0\\</mtext></math>");
  EXPECT_EQ(of("a < b"),
            "<math><mi>a</mi><mo form=\"infix\">&lt;</mo></math><wbr/>"
            "<math><mi>b</mi></math>");
}

TEST(MathML, what_is_not_known_gives_nothing) {
  for (const char* latex :
       {"\\input{x}", "{", "}", "\\frac{1}", "\\begin{tabular}", "a$b", "\\left( a",
        "\\mathbb{K}", "\\text{a", "\\begin{pmatrix} a", "#", "\x80"})
    EXPECT_FALSE(mathml(latex)) << latex;
}

TEST(MathML, deep_nests_are_refused_and_not_a_crash) {
  EXPECT_FALSE(mathml(std::string(100'000, '{')));
  std::string roots;
  for (int i = 0; i < 5'000; ++i) roots += "\\sqrt{";
  EXPECT_FALSE(mathml(roots));
}

TEST(MathML, any_pieces_in_any_order_are_well_formed_or_nothing) {
  const std::vector<std::string> pieces = {"{",
                                           "}",
                                           "\\frac",
                                           "\\sqrt",
                                           "[",
                                           "]",
                                           "\\left",
                                           "\\right",
                                           "(",
                                           ")",
                                           "^",
                                           "_",
                                           "'",
                                           "a",
                                           "1",
                                           "\\text{<b>}",
                                           "&",
                                           "\\\\",
                                           "\\begin{pmatrix}",
                                           "\\end{pmatrix}",
                                           "\\begin{array}{c}",
                                           "\\end{array}",
                                           "<",
                                           "\\hat",
                                           " ",
                                           "\\sum",
                                           "\\alpha",
                                           "\\operatorname{x\\_y}"};
  std::mt19937 dice(7);
  int understood = 0;
  for (int run = 0; run < 20'000; ++run) {
    std::string latex;
    const std::size_t length = 1 + dice() % 12;
    for (std::size_t i = 0; i < length; ++i) latex += pieces[dice() % pieces.size()];
    const auto made = mathml(latex);
    if (!made) continue;
    ++understood;
    EXPECT_EQ(not_well_formed(*made), "") << latex;
  }
  EXPECT_GT(understood, 500);
}

}  // namespace
}  // namespace seam::report
