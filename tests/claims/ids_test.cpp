// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/ids.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace seam::claims {
namespace {

std::shared_ptr<const text::Source> source(const std::string& name, const std::string& bytes) {
  return std::make_shared<const text::Source>(text::Source{name, bytes});
}

std::vector<std::string> ids_by_meaning(const Meaning& meaning) {
  std::vector<std::string> ids;
  for (const auto& item : meaning.items) {
    if (const auto* claim = std::get_if<MeantClaim>(&item)) ids.push_back(claim->claim.id);
    if (const auto* table = std::get_if<MeantTable>(&item))
      for (const auto& row : table->rows)
        for (const MeantClaim& cell : row.cells) ids.push_back(cell.claim.id);
  }
  return ids;
}

TEST(Ids, are_known_without_meaning_and_in_the_same_order) {
  const auto file = parse(source("a.seam", R"(
claim first: 1 + 1 = 2
include "b.seam"
include "b.seam"
table areas "areas of squares" for n in 1..3 labelled "one", "Übergröße", "--":
    "side"        n   ~ 1.0, 2.0, 3.0
    "square, too" n^2 ~ 1.0, 4.0, 9.0 corrected 9.00
table roots for n in 4..5:
    "--" sqrt(n) ~ 2.00, 2.24
claim last "the title": 1 < 2
)"));
  const Opener open = [](const std::string& path) {
    return path == "b.seam" ? source(path, "claim b.included: 2 < 3\n") : nullptr;
  };
  ASSERT_TRUE(file.errors.empty()) << file.errors.front().message;
  const Meaning meaning = mean(file.file, open);
  std::vector<std::string> ids;
  for (const Named& named : named_claims(file.file, open)) ids.push_back(named.id);
  EXPECT_EQ(ids, ids_by_meaning(meaning));
  EXPECT_EQ(ids.size(), 11);
  EXPECT_EQ(named_claims(file.file, open).back().title, "the title");
}

}  // namespace
}  // namespace seam::claims
