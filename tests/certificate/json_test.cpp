// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "certificate/json.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "certificate/fault.h"

namespace seam::certificate {
namespace {

// One step of every kind.
Elimination elimination() {
  const Pieces tree{{{}}, Relation::negative, -1, -1};
  Elimination result;
  result.steps.resize(4);
  result.steps[0].combination = {{0, 2}, {1, 3}};
  result.steps[0].factors = {{2, 1, -1, {tree}}, {3, 2, -1, {}}, {4, 1, 0, {}}};
  result.steps[1].kind = EliminationStep::Kind::cases;
  result.steps[1].formula = 5;
  result.steps[2].kind = EliminationStep::Kind::solution;
  result.steps[2].index = 1;
  result.steps[2].equations = {3};
  result.steps[3].kind = EliminationStep::Kind::outside;
  result.steps[3].index = 1;
  result.steps[3].formula = 2;
  result.steps[3].combination = {{1}, {4}};
  result.steps[3].remainder = 6;
  result.steps[3].positive = {tree, tree};
  result.steps[3].broken = {tree};
  return result;
}

// One entry of every kind.
Certificate example() {
  Certificate c;
  c.claim = "icosoid.smooth";
  c.verdict = Verdict::proven;
  c.using_claims = {"a", "b:1"};
  Statement& s = c.statement;
  s.nodes = {{Node::Kind::constant, "-3/4", {}, 0}, {Node::Kind::symbol, "sqrt(5)", {}, 0},
             {Node::Kind::sum, {}, {0, 1}, 0},      {Node::Kind::product, {}, {}, 0},
             {Node::Kind::power, {}, {1}, 2},       {Node::Kind::symbol, "\"é\\\n", {}, 0}};
  s.generators = {{"sqrt(5)", 4, "2", "9/4"}};
  s.functions = {{"sqrt(u)", 2, 2}, {"cbrt(v)", 4, 3}};
  const Simplex segment = {{"u"}, {{0, 1}, {2, 3}}, {false, true}};
  s.obligations = {
      Zero{2},
      Sign{4, Relation::nonpositive, {{segment}, {{2, Relation::nonzero}}}},
      Solutions{{2, 4}, "u", {"v", "w"}, segment, {{3, {}, {}}, {-1, "0", "1/2"}}},
      Gluing{{{{0, 1}, {1, 0}}, {{0, 1}, {1, 0}}}, {{0, 0, 1, 0, true}, {0, 1, 1, 1}}, 2},
      Distinct{{{0, 1}, {1, 0}}},
      Zero{0},
      Sign{1, Relation::zero, {}},
      OnlySolutions{{2}, {"v"}, {"w"}, {{segment}, {{5, Relation::positive}}}, {{{3}, {0}}}},
      OneSolution{{2}, {"u"}, {"w"}, {{segment}, {{5, Relation::positive}}}, {"0"}, {"1/2"}},
      Mesh{3,
           {{0, 1, 2}, {0, 0, 1}, {1, 1, 1}},
           {{0, 1, 2}, {2, 1, 0}},
           {0},
           Mesh::Property::planar,
           {1}}};
  s.guards = {0, 3};
  s.goal = {Goal::Kind::all,
            {{Goal::Kind::obligation, {}, 0},
             {Goal::Kind::any, {}, -1},
             {Goal::Kind::negation, {{Goal::Kind::obligation, {}, 4}}, -1},
             {Goal::Kind::suffices, {{Goal::Kind::obligation, {}, 4}}, -1}},
            -1};
  c.evidence.generators = {{"r", 7, "-1", "1"}};
  c.evidence.nodes = {{Node::Kind::symbol, "r", {}, 0}, {Node::Kind::sum, {}, {6, 0, 5}, 0}};
  Pieces pieces;
  pieces.steps = {{Step::Kind::split, 0, {0, 7}}, {}, {Step::Kind::outside, 3, {}}};
  Pieces square = pieces;
  square.side = Relation::negative;
  square.square = 6;
  square.cofactor = 7;
  using enum Reduction::Kind;
  const Reduction sum = {combination, {6, 0}, {1, 0}, {square, Computation{}}};
  const Reduction inner = {conjugate, {6}, {}, {sum, Computation{}}};
  const Reduction both_of = {both, {}, {}, {Computation{}, pieces}};
  const Reduction nested = {
      multiplier, {7}, {}, {pieces, Reduction{cases, {5}, {}, {inner, both_of}}}};
  const Point point = {{"u", "v"}, {6, 7}};
  c.evidence.proofs = {Computation{},
                       square,
                       Roots{1, {2}, {3, 4}, {1, 2}, 5, {pieces}, {pieces, square}},
                       Nothing{"time", "no more"},
                       Witness{point, {point}},
                       WrongSolution{3, -1},
                       nested,
                       elimination(),
                       Isolation{{{"1/2"}},
                                 {{"0"}, {"1/3"}},
                                 {{"-1"}, {"2"}},
                                 {pieces, square},
                                 {pieces},
                                 {square},
                                 {pieces, pieces}},
                       Computation{}};
  return c;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto place = text.find(from);
  EXPECT_NE(place, std::string::npos) << from << " in " << text;
  return text.replace(place, from.size(), to);
}

TEST(Json, reading_what_was_written_gives_the_same) {
  EXPECT_EQ(read(write(example())), example());
  EXPECT_EQ(read(write(Certificate{})), Certificate{});
  for (const Verdict verdict :
       {Verdict::proven, Verdict::refuted, Verdict::conditional, Verdict::undecided}) {
    Certificate c = example();
    c.verdict = verdict;
    c.correction = !c.correction;
    EXPECT_EQ(read(write(c)), c);
  }
  for (const Relation relation :
       {Relation::positive, Relation::nonnegative, Relation::zero, Relation::nonzero,
        Relation::nonpositive, Relation::negative}) {
    Certificate c = example();
    std::get<Sign>(c.statement.obligations[1]).relation = relation;
    EXPECT_EQ(read(write(c)), c);
  }
}

TEST(Json, writing_is_deterministic_and_ends_with_one_newline) {
  const std::string text = write(example());
  EXPECT_EQ(text, write(read(text)));
  EXPECT_TRUE(text.ends_with("}\n"));
}

TEST(Json, lines_are_short_however_long_the_lists) {
  Certificate c = example();
  for (int i = 0; i < 1000; ++i) c.statement.nodes.push_back({Node::Kind::sum, {}, {i, 0}, 0});
  c.evidence.nodes.clear();
  c.evidence.generators.clear();
  c.evidence.proofs.assign(c.statement.obligations.size(), Nothing{});
  const std::string text = write(c);
  EXPECT_EQ(read(text), c);
  std::size_t start = 0;
  for (std::size_t end; (end = text.find('\n', start)) != std::string::npos; start = end + 1)
    EXPECT_LE(end - start, 100u) << text.substr(start, end - start);
}

TEST(Json, the_digest_is_of_the_statement_alone) {
  Certificate c = example();
  const std::string digest_before = digest(c.statement);
  EXPECT_EQ(digest_before.size(), 64u);
  EXPECT_EQ(digest(read(write(c)).statement), digest_before);
  c.statement.goal.parts.pop_back();
  EXPECT_NE(digest(c.statement), digest_before);
}

TEST(Json, the_digest_is_sha_256_of_the_compact_text) {
  // printf '{"generators":[],"nodes":[],"obligations":[],"guards":[],"goal":{"all":[]}}' |
  // sha256sum
  EXPECT_EQ(digest(Statement{}),
            "e28fdd29c9597c68bc7e77939233cd4d9725b632c1da53f350ddb4b501945640");
}

TEST(Json, a_name_that_is_not_utf_8_is_not_written) {
  Certificate c = example();
  c.claim = "\xff";
  EXPECT_THROW(write(c), FormatError);
}

// Text that must be rejected.

void expect_rejected(const std::string& text, const std::string& words) {
  try {
    read(text);
    ADD_FAILURE() << "accepted: " << text.substr(0, 200);
  } catch (const FormatError& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(Json, text_that_is_no_json_is_rejected) {
  for (const char* text : {"", "{", "null", "[]", "3", "\"\xff\"", "{}x", "{\"a\":1e999}"})
    EXPECT_THROW(read(text), FormatError) << text;
  EXPECT_THROW(read(std::string("\0", 1)), FormatError);
}

TEST(Json, deep_brackets_are_rejected_without_a_crash) {
  for (const std::string bracket : {"[", "{\"a\":", "[[],"}) {
    std::string text;
    while (text.size() < 5'000'000) text += bracket;
    expect_rejected(text, "nested too deeply");
  }
}

TEST(Json, too_long_a_text_is_rejected) {
  expect_rejected(std::string(max_bytes + 1, ' '), "longer");
}

TEST(Json, brackets_in_strings_are_no_brackets) {
  Certificate c = example();
  c.claim = std::string(5000, '[') + "\"\\" + std::string(5000, '{');
  EXPECT_EQ(read(write(c)), c);
}

TEST(Json, a_member_too_many_or_too_few_is_rejected) {
  const std::string text = write(example());
  expect_rejected(replaced(text, "\"claim\"", "\"name\""), "no member 'name'");
  expect_rejected(replaced(text, "\"correction\": false,", ""), "a member 'correction'");
  expect_rejected(replaced(text, "\"guards\":", "\"guard\":"), "statement: expected no member");
}

TEST(Json, an_unknown_kind_is_rejected) {
  const std::string text = write(example());
  expect_rejected(replaced(text, "{\"power\":", "{\"root\":"), "nodes[4]");
  expect_rejected(replaced(text, "{\"zero\":", "{\"one\":"), "obligations[0]");
  expect_rejected(replaced(text, "\"computation\"", "\"trust me\""), "proofs[0]");
  expect_rejected(replaced(text, "{\"any\":", "{\"some\":"), "goal");
  expect_rejected(replaced(text, "\"plain\"", "\"clear\""), "a step");
  expect_rejected(replaced(text, "\"<=\"", "\"=<\""), "relation");
  expect_rejected(replaced(text, "\"proven\"", "\"true\""), "verdict");
  expect_rejected(replaced(text, "certificate 1", "certificate 2"), "format");
}

TEST(Json, numbers_that_are_no_small_integers_are_rejected) {
  const std::string text = write(example());
  for (const char* number : {"1.0", "2147483648", "-2147483649", "18446744073709551615",
                             "99999999999999999999999", "\"1\"", "true", "null", "1e0"})
    expect_rejected(replaced(text, "\"euler\": 2", "\"euler\": " + std::string(number)),
                    "an integer");
}

TEST(Json, indices_that_point_outside_or_forward_are_rejected) {
  const std::string text = write(example());
  expect_rejected(replaced(text, "{\"sum\":[0,1]}", "{\"sum\":[0,2]}"), "before it");
  expect_rejected(replaced(text, "{\"sum\":[0,1]}", "{\"sum\":[0,-1]}"), "before it");
  expect_rejected(replaced(text, "{\"zero\":2}", "{\"zero\":6}"), "before it");
}

TEST(Json, a_statement_without_functions_does_not_speak_of_them) {
  Certificate c = example();
  EXPECT_NE(write(c).find("\"functions\""), std::string::npos);
  c.statement.functions.clear();
  EXPECT_EQ(write(c).find("\"functions\""), std::string::npos);
  EXPECT_EQ(read(write(c)), c);
}

TEST(Json, a_function_is_a_root_of_degree_2_or_more_of_a_node) {
  const std::string text = write(example());
  expect_rejected(replaced(text, "\"degree\":3", "\"degree\":1"), "degree below 2");
  expect_rejected(replaced(text, "\"radicand\":4", "\"radicand\":6"), "before it");
  expect_rejected(replaced(text, "\"cbrt(v)\"", "\"\""), "without a name");
}

TEST(Json, proofs_of_a_sign_have_the_parts_of_their_rule) {
  const std::string text = write(example());
  expect_rejected(replaced(text, "\"below\"", "\"beside\""), "no member 'beside'");
  expect_rejected(replaced(text, "\"multiplier\": 7", "\"multiplier\": 8"), "before it");
  expect_rejected(replaced(text, "\"cofactors\": [6,0]", "\"cofactors\": [6]"), "one cofactor");
  expect_rejected(replaced(text, "\"combination\": [1,0]", "\"combination\": [1,-1]"),
                  "negative index");
}

TEST(Json, a_proof_that_is_nested_too_deeply_is_rejected) {
  Certificate c = example();
  auto& proofs = c.evidence.proofs;
  const auto place = std::ranges::find_if(
      proofs, [](const Proof& proof) { return std::holds_alternative<Reduction>(proof); });
  Reduction& proof = std::get<Reduction>(*place);
  for (int depth = 0; depth < 60; ++depth)
    proof = Reduction{Reduction::Kind::cases, {0}, {}, {Reduction(proof), Computation{}}};
  expect_rejected(write(c), "proof is nested too deeply");
}

TEST(Json, rationals_have_one_spelling) {
  for (const char* text : {"0", "7", "-7", "1/2", "-10/3", "123456789012345678901234567890/7"})
    EXPECT_TRUE(is_rational(text)) << text;
  for (const char* text :
       {"",    "-",    "-0",   "00",  "01",  "+1",  "1/", "/2", "1/0",  "1/1",
        "0/2", "1/02", "1/-2", "--1", "1.5", "1e3", " 1", "1 ", "0x10", "1/2/3"})
    EXPECT_FALSE(is_rational(text)) << text;
  EXPECT_FALSE(is_rational(std::string(100'000, '9')));
}

TEST(Json, every_damaged_text_is_rejected_or_read) {
  const std::string text = write(example());
  std::mt19937 random(1);
  const auto below = [&random](std::size_t n) { return random() % n; };
  for (int i = 0; i < 20'000; ++i) {
    std::string damaged = text;
    for (std::size_t n = 1 + below(3); n > 0; --n) {
      const std::size_t place = below(damaged.size());
      switch (below(3)) {
        case 0:
          damaged[place] = static_cast<char>(below(256));
          break;
        case 1:
          damaged.erase(place, 1 + below(4));
          break;
        default:
          damaged.insert(place, damaged.substr(below(damaged.size()), below(6)));
      }
    }
    try {
      const Certificate c = read(damaged);
      EXPECT_EQ(read(write(c)), c);
    } catch (const FormatError&) {
    }
  }
}

}  // namespace
}  // namespace seam::certificate
