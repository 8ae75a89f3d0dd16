// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/mutation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "claims/excerpt.h"
#include "claims/mutation_sample.h"

namespace seam::claims {
namespace {

File file_of(const std::string& text) {
  Parsed parsed = parse(std::make_shared<const text::Source>(text::Source{"test.seam", text}));
  EXPECT_TRUE(parsed.errors.empty());
  return std::move(parsed.file);
}

// What becomes of the file, by all mutations of a kind; only the statement of the claim is
// told.
std::set<std::string> claims_after(const std::string& text, Mutation::Kind kind) {
  const File file = file_of(text);
  std::set<std::string> result;
  for (const Mutation& mutation : mutations(file))
    if (mutation.kind == kind && mutation.item + 1 == file.items.size())
      result.insert(format(mutated(file, mutation).items.back().claim.statement));
  return result;
}

using Kind = Mutation::Kind;
using Texts = std::set<std::string>;

TEST(Mutation, a_number_changes_by_one_unit_of_its_last_digit) {
  EXPECT_EQ(claims_after("claim a: 2 = 1.99\n", Kind::number),
            Texts({"3 = 1.99", "1 = 1.99", "2 = 2.00", "2 = 1.98"}));
  EXPECT_EQ(claims_after("claim a: 0.10 < 10\n", Kind::number),
            Texts({"0.11 < 10", "0.09 < 10", "0.10 < 11", "0.10 < 9"}));
}

TEST(Mutation, exponents_indices_and_ends_are_kinds_of_their_own) {
  EXPECT_EQ(claims_after("claim a: for x in [0, 1]: x^2 >= 0\n", Kind::power),
            Texts({"for x in [0, 1]: x^3 >= 0", "for x in [0, 1]: x^1 >= 0"}));
  EXPECT_EQ(claims_after("let v = (1, 2)\nclaim a: v[1] = 1\n", Kind::index),
            Texts({"v[2] = 1", "v[0] = 1"}));
  EXPECT_EQ(
      claims_after("claim a: for x in [0, 1): x >= 0\n", Kind::range),
      Texts({"for x in [1, 1): x >= 0", "for x in [0, 2): x >= 0", "for x in [0, 0): x >= 0",
             "for x in (0, 1]: x >= 0", "for x in [0, 1]: x >= 0"}));
}

TEST(Mutation, relations_and_connectives_change) {
  EXPECT_EQ(
      claims_after("claim a: 1 < 2 and 2 = 2\n", Kind::relation),
      Texts({"1 <= 2 and 2 = 2", "1 > 2 and 2 = 2", "1 < 2 and 2 != 2", "1 < 2 and 2 <= 2"}));
  EXPECT_EQ(claims_after("claim a: 1 < 2 and 2 = 2\n", Kind::connective),
            Texts({"1 < 2 or 2 = 2", "1 < 2", "2 = 2"}));
  EXPECT_EQ(claims_after("claim a: for all x where x > 0: x > 0\n", Kind::connective),
            Texts({"for all x: x > 0", "for some x where x > 0: x > 0"}));
}

TEST(Mutation, a_name_becomes_one_of_the_same_kind_that_is_defined_before) {
  EXPECT_EQ(
      claims_after("let a = 1\nlet f(x) = x\nparam c\nlet b = 2\nclaim x: a = 1\n", Kind::name),
      Texts({"b = 1"}));
  const File file = file_of("let a = 1\nlet b = a\nlet c = 3\nclaim x: b = 1\n");
  for (const Mutation& mutation : mutations(file))
    EXPECT_FALSE(mutation.item == 1 && mutation.kind == Kind::name);
}

TEST(Mutation, one_place_is_changed_and_no_other) {
  const File file = file_of(
      "let p = triangle_patch [ (0,0,1), (1,0,1); (0,1,1) ]\nparam t in [0, 1]\n"
      "claim a: norm2(p(t, 0)) > 0 and not (for some s in 1..3: s = t implies t < 2)\n"
      "    corrected: for (u,v) in triangle: p(u,v)[3] = 1\n");
  const std::string before = format(file);
  for (const Mutation& mutation : mutations(file)) {
    const File after = mutated(file, mutation);
    EXPECT_NE(format(after), before);
    int parts_changed = 0;
    for (std::size_t i = 0; i < file.items.size(); ++i) {
      const auto was = expressions_of(file.items[i]), is = expressions_of(after.items[i]);
      for (std::size_t k = 0; k < was.size(); ++k)
        parts_changed += same(*was[k], *is[k]) ? 0 : 1;
    }
    EXPECT_EQ(parts_changed, 1);
    const Difference shown = difference(file, mutation);
    EXPECT_NE(shown.before, shown.after);
    EXPECT_TRUE(shown.where.source);
  }
  EXPECT_EQ(format(file), before);
}

TEST(Excerpt, a_claim_stands_with_what_it_rests_on_and_nothing_else) {
  const File file = file_of(
      "let a = 1\nlet b = a + 1\nlet c = 7\nclaim x: c = 7\nclaim y: b = 2 using x\n"
      "table t \"\" for k in 1..2:\n    \"one\" a*k ~ 1, 2\n    \"two\" c*k ~ 7, 14\n");
  const std::vector<Excerpt> all = excerpts(file);
  ASSERT_EQ(all.size(), 6u);
  EXPECT_EQ(all[1].id, "y");
  EXPECT_EQ(format(all[1].file), "let a = 1\nlet b = a + 1\n\nclaim y:\n    b = 2\n");
  EXPECT_EQ(all[3].id, "t.one.2");
  EXPECT_EQ(all[5].id, "t.two.2");
  EXPECT_EQ(all[5].file.items.size(), 2u);
}

TEST(Sample, the_same_seed_draws_the_same_and_another_others) {
  const File file = file_of("let f(x) = x^2 + 3*x - 1\nclaim a: f(2) = 9 and f(1) = 3\n");
  const auto drawn = [&](std::uint64_t seed) {
    std::string text;
    for (const Mutation& mutation : sample(file, 6, seed))
      text += format(mutated(file, mutation));
    return text;
  };
  EXPECT_EQ(drawn(1), drawn(1));
  EXPECT_NE(drawn(1), drawn(2));
  EXPECT_EQ(sample(file, 100'000, 1).size(), mutations(file).size());
}

}  // namespace
}  // namespace seam::claims
