// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tree.h"

namespace seam::claims {
namespace {

File file(const std::string& bytes) {
  Parsed parsed = parse(source(bytes));
  EXPECT_EQ(messages(parsed), "");
  return std::move(parsed.file);
}

Item item(const std::string& bytes) {
  File all = file(bytes);
  EXPECT_EQ(all.items.size(), 1u);
  return all.items.empty() ? Item{} : std::move(all.items.front());
}

// ---- values

TEST(Parse, operators_bind_as_usual) {
  EXPECT_EQ(tree("a + b*c^d"), "(binary + a (binary * b (binary ^ c d)))");
  EXPECT_EQ(tree("a - b - c"), "(binary - (binary - a b) c)");
  EXPECT_EQ(tree("a/b*c"), "(binary * (binary / a b) c)");
  EXPECT_EQ(tree("a^b^c"), "(binary ^ a (binary ^ b c))");
  EXPECT_EQ(tree("(a + b)*c"), "(binary * (binary + a b) c)");
}

TEST(Parse, minus_binds_looser_than_power_and_tighter_than_product) {
  EXPECT_EQ(tree("-x^2"), "(negate (binary ^ x 2))");
  EXPECT_EQ(tree("-x*y"), "(binary * (negate x) y)");
  EXPECT_EQ(tree("2^-3^2"), "(binary ^ 2 (negate (binary ^ 3 2)))");
  EXPECT_EQ(tree("--x - -y"), "(binary - (negate (negate x)) (negate y))");
}

TEST(Parse, a_range_is_no_decimal) {
  EXPECT_EQ(tree("0..5"), "(range 0 5)");
  EXPECT_EQ(tree("0.25"), "0.25");
  EXPECT_EQ(tree("0.25..1.5"), "(range 0.25 1.5)");
  EXPECT_EQ(tree("n..n + 1"), "(range n (binary + n 1))");
  EXPECT_EQ(tree("00.50"), "00.50");
}

TEST(Parse, names_have_dots_primes_and_greek_letters) {
  EXPECT_EQ(tree("icosoid.smooth"), "icosoid.smooth");
  EXPECT_EQ(tree("x'' + x_1'"), "(binary + x'' x_1')");
  EXPECT_EQ(tree("γ_f1"), "gamma_f1");
  EXPECT_EQ(tree("αβ + Δx + µ"), "(binary + (binary + alphabeta Deltax) mu)");
  EXPECT_EQ(tree("forest + inner + android"), "(binary + (binary + forest inner) android)");
}

TEST(Parse, signs_have_a_spelling_in_ascii) {
  EXPECT_EQ(tree("√5·x"), tree("sqrt(5)*x"));
  EXPECT_EQ(tree("√√x^2"), "(binary ^ (call sqrt (call sqrt x)) 2)");
  EXPECT_EQ(tree("√f(x)"), tree("sqrt(f(x))"));
  EXPECT_EQ(tree("a ≤ b"), tree("a <= b"));
  EXPECT_EQ(tree("a ≥ b ≠ c ≈ d"), tree("a >= b != c ~ d"));
  EXPECT_EQ(tree("∀ u ∈ A: ∃ v: ¬ a ∧ b ∨ c"),
            tree("for u in A: for some v: not a and b or c"));
  EXPECT_EQ(tree("∀ u: a"), tree("for all u: a"));
}

TEST(Parse, brackets_are_tuples_lists_and_matrices) {
  EXPECT_EQ(tree("(a)"), "a");
  EXPECT_EQ(tree("(a, b)"), "(tuple a b)");
  EXPECT_EQ(tree("[]"), "(list)");
  EXPECT_EQ(tree("[a]"), "(list a)");
  EXPECT_EQ(tree("[a, b; c, d]"), "(matrix (list a b) (list c d))");
  EXPECT_EQ(tree("[a, b; c, d;]"), tree("[a, b; c, d]"));
  EXPECT_EQ(tree("[1; 2]"), "(matrix (list 1) (list 2))");
}

TEST(Parse, calls_and_indices_follow_one_another) {
  EXPECT_EQ(tree("D2(p)(u, 0)"), "(call (call D2 p) u 0)");
  EXPECT_EQ(tree("M[1, 2][3]"), "(index (index M 1 2) 3)");
  EXPECT_EQ(tree("(p + q)(u)"), "(call (binary + p q) u)");
  EXPECT_EQ(tree("f()"), "(call f)");
}

TEST(Parse, an_argument_may_be_named) {
  EXPECT_EQ(tree("subst(E, u = 1/3)"), "(call subst E (named u (binary / 1 3)))");
  EXPECT_EQ(tree("f((u = 1))"), "(call f (relation = u 1))");
  EXPECT_EQ(tree("f(u + 1 = 1)"), "(call f (relation = (binary + u 1) 1))");
}

TEST(Parse, each_takes_the_expression_before_it) {
  EXPECT_EQ(tree("[E for i in 0..3]"), "(list (each E (binding in (list i) (range 0 3))))");
  EXPECT_EQ(tree("max(E for (u, v) in T where u < v)"),
            "(call max (each E (binding in (list u v) T (relation < u v))))");
  EXPECT_EQ(tree("f(E for i in A, j in B, k)"),
            "(call f (each E (binding in (list i) A) (binding in (list j) B)) k)");
  EXPECT_EQ(tree("limit(E for n -> infinity)"), "(call limit (limit n E (infinity)))");
}

TEST(Parse, a_plane_is_a_normal_and_an_offset) {
  EXPECT_EQ(tree("plane (1, 0, 0) -1/2"), "(plane (tuple 1 0 0) (binary / (negate 1) 2))");
  EXPECT_EQ(tree("plane normal(f) d + 1"), "(plane (call normal f) (binary + d 1))");
  EXPECT_EQ(tree("plane n (d)"), "(plane n d)");
}

TEST(Parse, nets_are_printed_in_rows_or_indexed) {
  EXPECT_EQ(tree("triangle_patch [ a, b; c; ]"), "(patch triangle_patch (list a b) (list c))");
  EXPECT_EQ(tree("curve [ a, b ]"), "(patch curve (list a b))");
  EXPECT_EQ(tree("triangle_patch 1 { 100: a; 010: b + c; 001: d; }"),
            "(indexed triangle_patch 1 (control 100 a) (control 010 (binary + b c)) (control "
            "001 d))");
  EXPECT_EQ(tree("rational quad_patch [ P:w, (1, 2):1/2 ]"),
            "(patch rational quad_patch (list (weighted P w) (weighted (tuple 1 2) (binary / 1 "
            "2))))");
  EXPECT_EQ(tree("rational curve 1 { 0: P:2 }"),
            "(indexed rational curve 1 (control 0 (weighted P 2)))");
  EXPECT_EQ(tree("quad_patch from (u, v, u*v)"),
            "(from quad_patch (tuple u v (binary * u v)))");
  EXPECT_EQ(tree("read \"cap.bv\""), "(read cap.bv)");
}

// ---- statements

TEST(Parse, relations_chain) {
  EXPECT_EQ(tree("a < b <= c"), "(relation < <= a b c)");
  EXPECT_EQ(tree("(a < b) = c"), "(relation = (relation < a b) c)");
  EXPECT_EQ(tree("a = (b < c)"), "(relation = a (relation < b c))");
  EXPECT_EQ(tree("E ~ 3.24 truncated"), "(truncated (relation ~ E 3.24))");
}

TEST(Parse, connectives_bind_as_usual) {
  EXPECT_EQ(tree("a or b and not c"), "(disjunction a (conjunction b (negation c)))");
  EXPECT_EQ(tree("a implies b implies c"), "(implication a (implication b c))");
  EXPECT_EQ(tree("a iff b implies c"), "(equivalence a (implication b c))");
  EXPECT_EQ(tree("not a = b and c"), "(conjunction (negation (relation = a b)) c)");
}

TEST(Parse, a_quantifier_reaches_as_far_as_it_can) {
  EXPECT_EQ(tree("for all u: a and b iff c"),
            "(for_all (binding all (list u)) (equivalence (conjunction a b) c))");
  EXPECT_EQ(tree("a and for some u: b or c"),
            "(conjunction a (for_some (binding all (list u)) (disjunction b c)))");
}

TEST(Parse, a_binding_has_names_a_set_and_a_condition) {
  EXPECT_EQ(tree("for all u, v where u < v: a"),
            "(for_all (binding all (list u v) (relation < u v)) a)");
  EXPECT_EQ(
      tree("for u in [0,1], v in [0,1): a"),
      "(for_all (binding in (list u) (list 0 1)) (binding in (list v) (half_open [) 0 1)) a)");
  EXPECT_EQ(tree("for x in (0,1]: a"), "(for_all (binding in (list x) (half_open (] 0 1)) a)");
  EXPECT_EQ(tree("for x in (0,1): a"), "(for_all (binding in (list x) (tuple 0 1)) a)");
  EXPECT_EQ(tree("for (u,v) in triangle where u < v: a"),
            "(for_all (binding in (list u v) triangle (relation < u v)) a)");
  EXPECT_EQ(tree("for k in 0..5: a"), "(for_all (binding in (list k) (range 0 5)) a)");
}

TEST(Parse, solve_has_unknowns_a_statement_a_condition_and_solutions) {
  EXPECT_EQ(tree("solve a, b: for all u: f where a gives (1, 2), (3, 4)"),
            "(solve (list a b) (for_all (binding all (list u)) f) (list a) "
            "(list (tuple 1 2) (tuple 3 4)))");
  EXPECT_EQ(tree("solve x: f gives none"), "(solve none (list x) f (list) (list))");
  EXPECT_EQ(tree("solve x in [0,1]: f gives one ~ 0.6"),
            "(solve one (list (binding in (list x) (list 0 1))) f (list) (list 0.6))");
  EXPECT_EQ(tree("solve x: f gives one"), "(solve one (list x) f (list) (list))");
}

// ---- items

TEST(Parse, the_words_of_headers_stay_usable_as_names) {
  EXPECT_EQ(tree("at + all + some + digits + source + vector + of").find("error"),
            std::string::npos);
}

TEST(Parse, a_claim_has_clauses_in_any_order) {
  const Claim claim = item(
                          "claim a:b at \"§6\" \"title\": x = 1 using c, d.e-f by bernstein, "
                          "subdivide 40, split(u, 2) expect refuted corrected: x = 2")
                          .claim;
  EXPECT_EQ(claim.id, "a:b");
  EXPECT_EQ(claim.title, "title");
  EXPECT_EQ(claim.at, "§6");
  EXPECT_EQ(tree(claim.statement), "(relation = x 1)");
  EXPECT_EQ(tree(claim.corrected.value()), "(relation = x 2)");
  EXPECT_EQ(claim.expect, "refuted");
  EXPECT_EQ(claim.using_claims, (std::vector<std::string>{"c", "d.e-f"}));
  ASSERT_EQ(claim.hints.size(), 3u);
  EXPECT_EQ(tree(claim.hints[0]), "bernstein");
  EXPECT_EQ(tree(claim.hints[1]), "(call subdivide 40)");
  EXPECT_EQ(tree(claim.hints[2]), "(call split u 2)");
}

TEST(Parse, a_table_has_columns_and_rows) {
  const Item table = item(
      "table t \"T\" for k in 1..2 labelled \"a\", \"b\":\n"
      "\"x\" f(k) ~ 1.0, -2.5 truncated\n\"y\" g ~ 3, 4\n");
  EXPECT_EQ(table.name, "t");
  EXPECT_EQ(table.labels, (std::vector<std::string>{"a", "b"}));
  ASSERT_EQ(table.columns.size(), 1u);
  EXPECT_EQ(tree(table.columns[0]), "(binding in (list k) (range 1 2))");
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0].label, "x");
  EXPECT_TRUE(table.rows[0].truncated);
  ASSERT_EQ(table.rows[0].printed.size(), 2u);
  EXPECT_EQ(tree(table.rows[0].printed[1]), "(negate 2.5)");
  EXPECT_FALSE(table.rows[1].truncated);
}

TEST(Parse, a_root_has_its_polynomial_and_its_interval) {
  const Item root = item("root g of g^2 - 2 in [1, 2]");
  ASSERT_EQ(root.expressions.size(), 2u);
  EXPECT_EQ(tree(root.expressions[0]), "(binary - (binary ^ g 2) 2)");
  EXPECT_EQ(tree(root.expressions[1]), "(list 1 2)");
}

TEST(Parse, a_param_has_a_type_a_set_and_a_condition) {
  const Item param = item("param n, m : integer in 1..5 where n < m");
  EXPECT_EQ(param.names, (std::vector<std::string>{"n", "m"}));
  EXPECT_EQ(param.type, "integer");
  EXPECT_EQ(tree(param.expressions.at(0)), "(range 1 5)");
  EXPECT_EQ(tree(param.where.value()), "(relation < n m)");
  EXPECT_EQ(item("param x : vector 3").type, "vector 3");
}

TEST(Parse, comments_go_with_the_item_they_stand_above_or_in) {
  const File all =
      file("# one\n#two\n\nlet a = 1 + # three\n  2 # four\n# five\nlet b = 1\n# six");
  ASSERT_EQ(all.items.size(), 2u);
  EXPECT_EQ(all.items[0].comments, (std::vector<std::string>{"one", "two", "three", "four"}));
  EXPECT_EQ(all.items[1].comments, (std::vector<std::string>{"five"}));
  EXPECT_EQ(all.closing_comments, (std::vector<std::string>{"six"}));
}

TEST(Parse, a_span_is_where_a_node_stands) {
  const Item let = item("let a = f(x) + (y*z)");
  const Expression& sum = let.expressions[0];
  const auto text = [](const Expression& e) {
    return e.span.source->bytes.substr(e.span.begin, e.span.end - e.span.begin);
  };
  EXPECT_EQ(text(sum), "f(x) + (y*z)");
  EXPECT_EQ(text(sum.children[0]), "f(x)");
  EXPECT_EQ(text(sum.children[1]), "(y*z)");
  EXPECT_EQ(let.name_span.begin, 4u);
  EXPECT_EQ(let.name_span.end, 5u);
}

// ---- files

TEST(Parse, every_form_of_the_language_is_read) {
  std::ifstream in("tests/claims/grammar.seam");
  ASSERT_TRUE(in);
  std::stringstream bytes;
  bytes << in.rdbuf();
  EXPECT_EQ(file(bytes.str()).items.size(), 61u);
}

TEST(Parse, the_examples_of_the_reference_are_read) {
  std::ifstream in("docs/language.md");
  ASSERT_TRUE(in);
  std::string line, example;
  int examples = 0;
  for (bool inside = false; std::getline(in, line);) {
    if (inside && line == "```") {
      EXPECT_FALSE(file(example).items.empty());
      ++examples;
    }
    if (line.starts_with("```")) {
      inside = line == "```seam";
      example.clear();
    } else if (inside) {
      example += line + "\n";
    }
  }
  EXPECT_EQ(examples, 10);
}

TEST(Parse, line_ends_marks_and_a_missing_end_make_no_difference) {
  const std::string text = "# c\nlet a = 1\n\nclaim b:\n    a = 1\n";
  std::string windows;
  for (const char c : text) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_TRUE(same(file(text), file(windows)));
  EXPECT_TRUE(same(file(text), file("\xEF\xBB\xBF" + text)));
  EXPECT_TRUE(same(file(text), file(text.substr(0, text.size() - 1))));
  EXPECT_TRUE(file("").items.empty());
  EXPECT_TRUE(file("\xEF\xBB\xBF").items.empty());
  EXPECT_TRUE(file("\n# only\n").items.empty());
}

}  // namespace
}  // namespace seam::claims
