// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/similarity.h"

#include <gtest/gtest.h>

#include "nets.h"
#include "spheroids.h"
#include "truth.h"

namespace seam::geometry {
namespace {

using namespace testing;

class SimilarityTest : public ::testing::Test {
 protected:
  Surface moved(const Surface& s, const Formula& k, const Matrix& m, const Point& shift) const {
    std::vector<Patch> patches;
    for (const Patch& p : s.patches)
      patches.push_back(
          parametrisations(map(p, [&](const Point& x) { return k * (m * x) + shift; }))[3]);
    return surface({patches.rbegin(), patches.rend()}, numbers);
  }
  bool are_similar(const Surface& s, const Surface& t) {
    return holds(similar(s, t, numbers), numbers);
  }
  bool are_congruent(const Surface& s, const Surface& t) {
    return holds(congruent(s, t, numbers), numbers);
  }

  symbolic::Numbers numbers;
  const Matrix turn{{{ratio(2, 3), ratio(-1, 3), ratio(2, 3)},
                     {ratio(2, 3), ratio(2, 3), ratio(-1, 3)},
                     {ratio(-1, 3), ratio(2, 3), ratio(2, 3)}}};
  const Matrix mirror{{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}}};
  // A patch without any symmetry.
  const Surface odd =
      surface({triangle_of({u + v * v, 3 * v - u* u, u* v + 2 * u* u}, 2, numbers)}, numbers);
};

TEST_F(SimilarityTest, a_moved_surface_is_congruent) {
  EXPECT_TRUE(are_congruent(odd, moved(odd, 1, turn, {1, 2, 3})));
  EXPECT_TRUE(are_congruent(octoid(numbers), moved(octoid(numbers), 1, turn, {1, 2, 3})));
}

TEST_F(SimilarityTest, a_mirrored_surface_is_congruent) {
  EXPECT_TRUE(are_congruent(odd, moved(odd, 1, mirror, {0, 0, 5})));
}

TEST_F(SimilarityTest, a_scaled_surface_is_similar_and_not_congruent) {
  const Surface large = moved(odd, numbers.sqrt(2), turn, {1, 0, 0});
  EXPECT_TRUE(are_similar(odd, large));
  EXPECT_TRUE(are_similar(large, odd));
  EXPECT_FALSE(are_congruent(odd, large));
}

TEST_F(SimilarityTest, the_similarity_is_said) {
  const Proposition p = similar(odd, moved(odd, 3, mirror, {1, 0, 0}), numbers);
  EXPECT_EQ(p.parts.at(0).about,
            "x -> 3 * [1, 0, 0; 0, 1, 0; 0, 0, -1] * x + (1, 0, 0), of positive scale");
}

TEST_F(SimilarityTest, the_similarity_is_found) {
  const auto found = find_similarity(odd, moved(odd, 3, turn, {1, 0, 0}), numbers);
  ASSERT_TRUE(found);
  EXPECT_TRUE(numbers.equal(found->scale, 3));
  EXPECT_TRUE(numbers.equal(found->shift, {1, 0, 0}));
  for (int k = 0; k < 3; ++k) EXPECT_TRUE(numbers.equal(found->matrix.rows[k], turn.rows[k]));
}

TEST_F(SimilarityTest, raised_degrees_do_not_matter) {
  EXPECT_TRUE(are_congruent(odd, surface({elevate(odd.patches[0])}, numbers)));
}

TEST_F(SimilarityTest, a_stretched_surface_is_not_similar) {
  const Matrix stretch{{{1, 0, 0}, {0, 1, 0}, {0, 0, 2}}};
  EXPECT_FALSE(are_similar(odd, moved(odd, 1, stretch, {0, 0, 0})));
}

TEST_F(SimilarityTest, different_solids_are_not_similar) {
  EXPECT_FALSE(are_similar(octoid(numbers), hexoid(numbers)));
  EXPECT_FALSE(are_similar(octoid(numbers), tetroid(numbers)));
}

TEST_F(SimilarityTest, one_control_point_off_is_not_similar) {
  auto rows = odd.patches[0].rows();
  rows[0][1][2] += ratio(1, 1000000000);
  EXPECT_FALSE(are_similar(odd, surface({Patch::triangle(rows)}, numbers)));
}

TEST_F(SimilarityTest, flat_surfaces_can_be_congruent) {
  const Surface flat = surface({flat_triangle({0, 0, 0}, {1, 0, 0}, {0, 2, 0})}, numbers);
  EXPECT_TRUE(are_congruent(flat, moved(flat, 1, turn, {0, 0, 1})));
  EXPECT_FALSE(
      are_similar(flat, surface({flat_triangle({0, 0, 0}, {1, 0, 0}, {0, 3, 0})}, numbers)));
}

TEST_F(SimilarityTest, the_icosoid_is_similar_to_its_multiples) {
  const Surface s = icosoid(numbers);
  EXPECT_TRUE(are_similar(s, moved(s, numbers.sqrt(5), turn, {1, 1, 1})));
}

}  // namespace
}  // namespace seam::geometry
