// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "claims/latex.h"
#include "random_tree.h"
#include "tree.h"

namespace seam::claims {
namespace {

std::string typeset(const std::string& bytes) {
  const ParsedExpression parsed = parse_expression(source(bytes));
  EXPECT_TRUE(parsed.errors.empty()) << bytes;
  return latex(parsed.expression);
}

std::string item(const std::string& bytes) {
  return latex(parse(source(bytes)).file.items.at(0));
}

TEST(ExpressionLatex, names_are_symbols_with_subscripts_or_words) {
  EXPECT_EQ(latex_name("x"), "x");
  EXPECT_EQ(latex_name("x''"), "x''");
  EXPECT_EQ(latex_name("gamma_f1"), "\\gamma_{f1}");
  EXPECT_EQ(latex_name("alpha1"), "\\alpha_{1}");
  EXPECT_EQ(latex_name("K_max"), "K_{\\mathrm{max}}");
  EXPECT_EQ(latex_name("x0_i'"), "x_{0,i}'");
  EXPECT_EQ(latex_name("phi"), "\\varphi");
  EXPECT_EQ(latex_name("Alpha"), "\\mathit{Alpha}");
  EXPECT_EQ(latex_name("swap_xy"), "\\mathit{swap\\_xy}");
  EXPECT_EQ(latex_name("icosoid.p"), "\\mathit{icosoid}.p");
  EXPECT_EQ(latex_name("gauss", true), "\\operatorname{gauss}");
}

TEST(ExpressionLatex, quotients_are_fractions_and_need_no_parentheses) {
  EXPECT_EQ(typeset("(sqrt(5) + 1)/2"), "\\frac{\\sqrt{5} + 1}{2}");
  EXPECT_EQ(typeset("a/b*c"), "\\frac{a}{b} \\cdot c");
  EXPECT_EQ(typeset("(a/b)^2"), "{\\left( \\frac{a}{b} \\right)}^{2}");
}

TEST(ExpressionLatex, products_do_not_look_like_calls) {
  EXPECT_EQ(typeset("3*x^2"), "3 {x}^{2}");
  EXPECT_EQ(typeset("3*4"), "3 \\cdot 4");
  EXPECT_EQ(typeset("8*3^k"), "8 \\cdot {3}^{k}");
  EXPECT_EQ(typeset("2*(1/2)"), "2 \\cdot \\frac{1}{2}");
  EXPECT_EQ(typeset("diff(y, y)*y"),
            "\\left( \\frac{\\partial}{\\partial y} y \\right) \\cdot y");
  EXPECT_EQ(typeset("a*(b + c)"), "a \\cdot (b + c)");
  EXPECT_EQ(typeset("a*b"), "a\\, b");
  EXPECT_EQ(typeset("2*-x - -y"), "2 (-x) - (-y)");
  EXPECT_EQ(typeset("-(a + b)^2"), "-{(a + b)}^{2}");
}

TEST(ExpressionLatex, vectors_are_columns_and_matrices_are_arrays) {
  EXPECT_EQ(typeset("(1, 2)"), "\\begin{pmatrix} 1 \\\\ 2 \\end{pmatrix}");
  EXPECT_EQ(typeset("[1, 2; 3, 4]"), "\\begin{pmatrix} 1 & 2 \\\\ 3 & 4 \\end{pmatrix}");
  EXPECT_EQ(typeset("[(1, 2), x]"), "[(1, 2), \\allowbreak x]");
  EXPECT_EQ(typeset("curve [ (0, 1), x ]"),
            "\\text{curve }\\left[\\begin{array}{cc} (0, 1) & x \\end{array}\\right]");
}

TEST(ExpressionLatex, a_row_that_begins_with_a_bracket_is_no_distance) {
  EXPECT_EQ(typeset("(x, [y])"), "\\begin{pmatrix} x \\\\ {}[y] \\end{pmatrix}");
}

TEST(ExpressionLatex, functions_have_their_notation) {
  EXPECT_EQ(typeset("abs(x) + norm2(v)"), "\\lvert x \\rvert + {\\lVert v \\rVert}^{2}");
  EXPECT_EQ(typeset("dot(a, cross(b, c))"), "\\langle a, b \\times c \\rangle");
  EXPECT_EQ(typeset("2*cross(b, c)"), "2 (b \\times c)");
  EXPECT_EQ(typeset("binomial(n, i)"), "\\binom{n}{i}");
  EXPECT_EQ(typeset("sum(i for i in 1..n)"), "\\sum_{i=1}^{n} i");
  EXPECT_EQ(typeset("max(K for (u, v) in triangle)"),
            "\\max_{(u, v) \\in \\mathit{triangle}} K");
  EXPECT_EQ(typeset("limit(1/n for n -> infinity)"), "\\lim_{n \\to \\infty} \\frac{1}{n}");
  EXPECT_EQ(typeset("diff(f, u, 2)"), "\\frac{\\partial^{2}}{\\partial u^{2}} f");
  EXPECT_EQ(typeset("D2(p)(u, 0)"), "D_{2}(p)(u, \\allowbreak 0)");
  EXPECT_EQ(typeset("gauss(p)"), "\\operatorname{gauss}(p)");
  EXPECT_EQ(typeset("sqrt(1, 2)"), "\\operatorname{sqrt}(1, \\allowbreak 2)");
}

TEST(ExpressionLatex, statements_have_logical_signs) {
  EXPECT_EQ(typeset("for all u, v: u <= v"), "\\forall u, v\\colon\\ \\allowbreak u \\le v");
  EXPECT_EQ(
      typeset("for u in [0,1), (s,t) in T where s != t: E ~ 3.24 truncated"),
      "\\forall u \\in [0, \\allowbreak 1),\\ (s, t) \\in T\\text{ where }s \\ne t\\colon\\ "
      "\\allowbreak E \\approx 3.24\\text{ (truncated)}");
  EXPECT_EQ(typeset("for some x in (0,1): not x = 1 and (a or b)"),
            "\\exists x \\in (0, 1)\\colon\\ \\allowbreak \\lnot (x = 1) \\land (a \\lor b)");
  EXPECT_EQ(typeset("solve x: x^2 = 1 gives 1, -1"),
            "\\text{solve }x\\colon\\ \\allowbreak {x}^{2} = 1\\ \\allowbreak \\text{gives }1, "
            "\\allowbreak -1");
}

TEST(ExpressionLatex, items_are_definitions) {
  EXPECT_EQ(item("let f(x) = x^2"), "f(x) = {x}^{2}");
  EXPECT_EQ(item("define flat(p): K(p) = 0"), "\\operatorname{flat}(p) :\\iff K(p) = 0");
  EXPECT_EQ(item("param a, b"), "a, b \\in \\mathbb{R}");
  EXPECT_EQ(item("param c in (0, 1)"), "c \\in (0, 1)");
  EXPECT_EQ(item("param n : integer where n >= 3"),
            "n \\in \\mathbb{Z}\\text{ where }n \\ge 3");
  EXPECT_EQ(item("param x : vector 3"), "x \\in \\mathbb{R}^{3}");
  EXPECT_EQ(item("root g of g^2 - 2 in [1, 2]"),
            "g \\in [1, \\allowbreak 2],\\ {g}^{2} - 2 = 0");
  EXPECT_EQ(item("section \"x\""), "");
}

TEST(ExpressionLatex, texts_are_escaped) {
  EXPECT_EQ(latex_text("50% of $x_1$ & #2 {\\input}"),
            "\\text{50\\% of \\$x\\_1\\$ \\& \\#2 \\{\\textbackslash{}input\\}}");
  EXPECT_EQ(latex_text("α < β ~ ^"),
            "\\text{}\\alpha\\text{ }<\\text{ }\\beta\\text{ \\textasciitilde{} "
            "\\textasciicircum{}}");
  EXPECT_EQ(latex_text("中\x80\n"), "\\text{[U+4E2D][byte][U+000A]}");
}

TEST(ExpressionLatex, what_nests_too_deeply_for_tex_is_shown_as_source) {
  std::string bytes = "1";
  for (int i = 0; i < 100; ++i) bytes += "/2";
  EXPECT_TRUE(typeset(bytes).starts_with("\\text{1/2/2"));
}

// Braces and fences pair off, and nothing stands there that could end the formula.
bool is_contained(const std::string& tex) {
  std::vector<std::string> open;
  for (std::size_t i = 0; i < tex.size(); ++i) {
    const auto is = [&](const char* word) {
      return tex.compare(i, std::char_traits<char>::length(word), word) == 0;
    };
    if (is("\\left") && !is("\\lefta"))
      open.emplace_back("left");
    else if (is("\\begin{"))
      open.emplace_back("begin");
    else if (is("\\right") || is("\\end{")) {
      if (open.empty() || open.back() != (is("\\right") ? "left" : "begin")) return false;
      open.pop_back();
    }
    if (tex[i] == '\\') {
      ++i;
    } else if (tex[i] == '{') {
      open.emplace_back("{");
    } else if (tex[i] == '}') {
      if (open.empty() || open.back() != "{") return false;
      open.pop_back();
    } else if (tex[i] < ' ' || tex[i] > '~' ||
               std::string("$%#\"").find(tex[i]) != std::string::npos) {
      return false;
    } else if (tex[i] == '&' && (open.empty() || open.back() != "begin")) {
      return false;
    }
  }
  return open.empty();
}

TEST(ExpressionLatex, of_random_trees_is_contained_mathematics) {
  for (unsigned seed = 0; seed < 400; ++seed) {
    const Expression e = RandomTree(seed).statement(5);
    ASSERT_TRUE(is_contained(latex(e))) << seed << "\n" << latex(e);
  }
}

}  // namespace
}  // namespace seam::claims
