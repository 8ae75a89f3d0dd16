// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/rests_on.h"

#include <gtest/gtest.h>

namespace seam::claims {
namespace {

// The names of the items that the last claim of the text rests on.
std::string names(const std::string& text) {
  const auto source = std::make_shared<const text::Source>(text::Source{"test.seam", text});
  const Meaning meaning = mean(parse(source).file, [](const std::string&) { return nullptr; });
  EXPECT_TRUE(meaning.errors.empty());
  const Claim* claim = nullptr;
  for (const MeantItem& item : meaning.items)
    if (const auto* found = std::get_if<MeantClaim>(&item)) claim = &found->claim;
  std::string result;
  for (const Item* item : rests_on(meaning, *claim)) {
    std::string name = item->names.empty() ? item->name : "";
    for (const std::string& one : item->names) name += (name.empty() ? "" : "+") + one;
    result += (result.empty() ? "" : " ") + name;
  }
  return result;
}

TEST(RestsOn, a_claim_rests_on_what_it_names_and_on_what_that_names) {
  EXPECT_EQ(names("let a = 1\nlet b = a + 1\nlet c = 7\nclaim x: b = 2\n"), "a b");
}

TEST(RestsOn, parameters_roots_and_named_statements_count) {
  EXPECT_EQ(names("param p, q in (0, 1)\nroot r of r^2 - 2 in [0, 2]\n"
                  "define above(x): x < r\nclaim x: above(q)\n"),
            "p+q r above");
}

TEST(RestsOn, a_bound_name_is_not_that_of_a_definition) {
  EXPECT_EQ(names("let u = 1\nlet k = 2\nlet v = 3\n"
                  "claim x: for all u: sum(k*u for k in 1..2) = 3*u\n"),
            "");
  EXPECT_EQ(names("let x = 1\nlet f(x) = x^2\nclaim c: f(2) = 4\n"), "f");
  EXPECT_EQ(names("let x = 5\nclaim c: solve x: x^2 = 4 where x > 0 gives 2\n"), "");
}

TEST(RestsOn, a_name_is_bound_only_where_its_quantifier_reaches) {
  EXPECT_EQ(names("let u = 1\nclaim x: (for all u: u^2 >= 0) and u = 1\n"), "u");
}

TEST(RestsOn, what_the_correction_speaks_of_counts) {
  EXPECT_EQ(names("let a = 1\nlet b = 2\nclaim x: a = 2\n    corrected: b = 2\n"), "a b");
}

}  // namespace
}  // namespace seam::claims
