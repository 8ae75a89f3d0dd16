// SPDX-License-Identifier: GPL-3.0-or-later
#include "spheroids.h"

#include <gtest/gtest.h>

#include "truth.h"

namespace seam::geometry {
namespace {

using namespace testing;

struct Count {
  int patches, seams, corners;
  bool operator==(const Count&) const = default;
};

Count count(const Surface& s) {
  return {static_cast<int>(s.patches.size()), static_cast<int>(s.seams.size()),
          static_cast<int>(s.corners.size())};
}

using SpheroidMaker = Surface (*)(symbolic::Numbers&);

class Spheroid : public ::testing::TestWithParam<SpheroidMaker> {
 protected:
  symbolic::Numbers numbers_;
  Surface surface_ = GetParam()(numbers_);
};

TEST_P(Spheroid, is_closed) {
  EXPECT_TRUE(holds(closed(surface_, numbers_), numbers_));
  EXPECT_EQ(euler_characteristic(surface_), 2);
}
TEST_P(Spheroid, is_g1) {
  EXPECT_TRUE(holds(g1(surface_, numbers_), numbers_));
}
TEST_P(Spheroid, is_g2) {
  EXPECT_TRUE(holds(g2(surface_, numbers_), numbers_));
}

INSTANTIATE_TEST_SUITE_P(All, Spheroid, ::testing::Values(tetroid, hexoid, octoid, icosoid));

TEST(Spheroids, have_a_patch_a_vertex_a_seam_an_edge_a_corner_a_face) {
  symbolic::Numbers numbers;
  EXPECT_EQ(count(tetroid(numbers)), (Count{4, 6, 4}));
  EXPECT_EQ(count(hexoid(numbers)), (Count{6, 12, 8}));
  EXPECT_EQ(count(octoid(numbers)), (Count{8, 12, 6}));
  EXPECT_EQ(count(icosoid(numbers)), (Count{20, 30, 12}));
}

TEST(Spheroids, octoid_and_icosoid_are_convex) {
  symbolic::Numbers numbers;
  EXPECT_TRUE(holds(convex(octoid(numbers), numbers), numbers));
  EXPECT_TRUE(holds(convex(icosoid(numbers), numbers), numbers));
}

TEST(Spheroids, a_control_point_moved_a_little_breaks_them) {
  symbolic::Numbers numbers;
  for (const auto& [j, i] : std::vector<std::pair<int, int>>{{0, 0}, {0, 1}, {1, 1}, {2, 1}}) {
    auto rows = octoid_patch().rows();
    rows[j][i][2] += Formula(exact::Rational(1, 1000000));
    const Surface s =
        orbit(Patch::triangle(rows), rotations(octahedron(numbers), numbers), numbers);
    EXPECT_FALSE(holds(g1(s, numbers), numbers)) << j << i;
    EXPECT_FALSE(holds(convex(s, numbers), numbers)) << j << i;
  }
}

}  // namespace
}  // namespace seam::geometry
