// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/latex_assumptions.h"

#include <gtest/gtest.h>

#include "report/latex_graph.h"

namespace seam::report {
namespace {

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

ClaimRun claim(const std::string& id, std::vector<std::string> used = {}) {
  ClaimRun result;
  result.id = id;
  result.printed.verdict = Verdict::proven;
  result.using_claims = std::move(used);
  return result;
}

DefinitionRun parameter(const std::string& name) {
  return {name + " \\in (0,1)", {}, {name}, "", true};
}

TEST(Assumptions, a_file_whose_verdicts_rest_on_nothing_has_none) {
  FileRun file;
  file.items = {claim("a")};
  EXPECT_EQ(latex_assumptions(file), "");
}

TEST(Assumptions, a_parameter_is_named_with_the_number_of_claims_that_speak_of_it) {
  FileRun file;
  ClaimRun one = claim("a"), two = claim("b");
  one.definitions = two.definitions = {"c"};
  file.items = {parameter("c"), parameter("unused"), one, two};
  EXPECT_TRUE(
      holds(latex_assumptions(file), "c \\in (0,1)\\qquad\\text{\\SeamQuiet{in 2 claims}}"));
  EXPECT_FALSE(holds(latex_assumptions(file), "unused"));
}

TEST(Assumptions, a_guard_that_does_not_hold_is_named_with_its_claim) {
  FileRun file;
  ClaimRun open = claim("divided");
  using Status = ObligationRun::Status;
  open.printed.obligations = {
      {"", "sign", "", "c > 0", true, Status::holds, ""},
      {"the divisor is not 0", "sign", "", "d > 0", true, Status::open, ""}};
  file.items = {open};
  const std::string text = latex_assumptions(file);
  EXPECT_TRUE(holds(text, "1 condition under which the formulas mean something was proven"));
  EXPECT_TRUE(holds(text, "\\SeamObligation{open}"));
  EXPECT_TRUE(holds(text, "{\\texttt{divided}}"));
}

TEST(Graph, only_claims_that_rest_on_others_and_those_others_are_drawn) {
  FileRun file;
  file.items = {claim("alone"), claim("lemma"), claim("theorem", {"lemma"})};
  const std::string graph = latex_graph(file);
  EXPECT_FALSE(holds(graph, "alone"));
  EXPECT_TRUE(holds(graph, "\\draw[->,seamquiet] (c0east) to[out=0,in=180] (c1west);"));
}

TEST(Graph, a_line_over_several_columns_has_a_place_in_each) {
  FileRun file;
  file.items = {claim("a"), claim("b", {"a"}), claim("c", {"a", "b"})};
  const std::string graph = latex_graph(file);
  EXPECT_TRUE(holds(graph, "coordinate (c3west)"));
  EXPECT_TRUE(holds(graph, "(c0east) to[out=0,in=180] (c3west)"));
  EXPECT_TRUE(holds(graph, "(c3east) to[out=0,in=180] (c2west)"));
  EXPECT_FALSE(holds(graph, "(c0east) to[out=0,in=180] (c2west)"));
}

TEST(Graph, so_many_that_nobody_could_read_them_are_not_drawn) {
  FileRun file;
  file.items = {claim("base")};
  for (int i = 0; i < 100; ++i) file.items.push_back(claim("a" + std::to_string(i), {"base"}));
  EXPECT_EQ(latex_graph(file), "");
  EXPECT_TRUE(holds(latex_assumptions(file), "rests on"));
}

}  // namespace
}  // namespace seam::report
