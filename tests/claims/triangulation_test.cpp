// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/triangulation.h"

#include <gtest/gtest.h>

namespace seam::claims {
namespace {

using symbolic::Simplex;

// n! times the volume of a simplex with n + 1 corners, by expansion along the first row.
exact::Rational determinant(const std::vector<std::vector<exact::Rational>>& m) {
  if (m.empty()) return 1;
  exact::Rational sum = 0;
  for (std::size_t c = 0; c < m.size(); ++c) {
    std::vector<std::vector<exact::Rational>> rest;
    for (std::size_t r = 1; r < m.size(); ++r) {
      rest.push_back(m[r]);
      rest.back().erase(rest.back().begin() + static_cast<std::ptrdiff_t>(c));
    }
    const exact::Rational part = m[0][c] * determinant(rest);
    sum += c % 2 == 0 ? part : exact::Rational(-part);
  }
  return sum;
}

exact::Rational size(const Simplex& s) {
  std::vector<std::vector<exact::Rational>> edges;
  for (std::size_t i = 1; i < s.corners.size(); ++i) {
    edges.emplace_back();
    for (std::size_t j = 1; j < s.corners[i].size(); ++j)
      edges.back().push_back(s.corners[i][j].value() - s.corners[0][j].value());
  }
  return abs(determinant(edges));
}

TEST(Triangulation, a_square_is_two_triangles) {
  const auto all = triangulated({symbolic::interval("u", 0, 1), symbolic::interval("v", 0, 1)});
  ASSERT_EQ(all.size(), 2U);
  EXPECT_EQ(size(all[0]) + size(all[1]), 2);
  EXPECT_EQ(all[0].variables, (std::vector<std::string>{"u", "v"}));
}

TEST(Triangulation, the_simplices_fill_a_box_and_a_prism) {
  const auto box = triangulated({symbolic::interval("u", 0, 2), symbolic::interval("v", 1, 2),
                                 symbolic::interval("w", 0, 1)});
  EXPECT_EQ(box.size(), 6U);
  exact::Rational total = 0;
  for (const Simplex& s : box) total += size(s);
  EXPECT_EQ(total, 6 * 2);
  const auto prism =
      triangulated({symbolic::standard_simplex({"u", "v"}), symbolic::interval("w", 0, 1)});
  EXPECT_EQ(prism.size(), 3U);
  total = 0;
  for (const Simplex& s : prism) total += size(s);
  EXPECT_EQ(total, 3);
}

}  // namespace
}  // namespace seam::claims
