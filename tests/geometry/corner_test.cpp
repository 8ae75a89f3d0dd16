// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/winding.h"
#include "nets.h"
#include "truth.h"

namespace seam::geometry {
namespace {

using namespace testing;

// Flat triangles from the origin to each pair of successive points, the last joined to the
// first.
class CornerTest : public ::testing::Test {
 protected:
  Surface fan(const std::vector<std::pair<long, long>>& points, int parametrisation = 0) const {
    std::vector<Patch> patches;
    for (std::size_t k = 0; k < points.size(); ++k) {
      const auto& [ax, ay] = points[k];
      const auto& [bx, by] = points[(k + 1) % points.size()];
      const Patch p = flat_triangle({0, 0, 0}, {Formula(ax), Formula(ay), 0},
                                    {Formula(bx), Formula(by), 0});
      patches.push_back(parametrisations(p)[(parametrisation * k) % 6]);
    }
    return surface(patches, numbers);
  }

  const Corner& middle(const Surface& s) const {
    return *std::ranges::find_if(s.corners, [](const Corner& corner) { return corner.closed; });
  }

  void expect(const Surface& s, bool seams_hold, bool winds) const {
    ASSERT_EQ(std::ranges::count_if(s.corners, [](const Corner& c) { return c.closed; }), 1);
    EXPECT_EQ(middle(s).sectors.size(), s.patches.size());
    EXPECT_EQ(holds(winds_once(s, middle(s)), numbers), winds);
    EXPECT_EQ(holds(g1(s, numbers), numbers), seams_hold && winds);
    bool seams = true;
    for (const Seam& seam : s.seams) {
      Surface pair = surface({s.patches[seam.patch], s.patches[seam.other_patch]}, numbers);
      std::erase_if(pair.seams, [&](const Seam& other) {
        return other.side != seam.side || other.other_side != seam.other_side;
      });
      pair.corners.clear();
      seams = seams && holds(g1(pair, numbers), numbers);
    }
    EXPECT_EQ(seams, seams_hold);
  }

  symbolic::Numbers numbers;
};

TEST_F(CornerTest, three_sectors_wind_once) {
  expect(fan({{1, 0}, {-1, 1}, {-1, -1}}), true, true);
  expect(fan({{1, 0}, {-100, 1}, {0, -1}}), true, true);  // one angle nearly pi
}

TEST_F(CornerTest, four_to_eight_sectors_wind_once_however_they_are_parametrised) {
  for (int k = 0; k < 6; ++k) {
    expect(fan({{1, 0}, {0, 1}, {-1, 0}, {0, -1}}, k), true, true);
    expect(fan({{1, 0}, {1, 3}, {-2, 1}, {-2, -1}, {1, -3}}, k), true, true);
    expect(fan({{1, 0}, {50, 1}, {50, 2}, {50, 3}, {-50, 1}, {0, -1}}, k), true, true);
    expect(fan({{1, 0}, {1, 1}, {0, 1}, {-1, 1}, {-1, 0}, {-1, -1}, {0, -1}, {1, -1}}, k), true,
           true);
  }
}

TEST_F(CornerTest, sectors_the_other_way_round_wind_once) {
  expect(fan({{0, -1}, {-1, 0}, {0, 1}, {1, 0}}), true, true);
}

TEST_F(CornerTest, twice_round_is_no_corner_though_every_seam_is_g1) {
  expect(fan({{10, 0}, {-8, 6}, {3, -9}, {3, 9}, {-8, -6}}), true, false);
  expect(fan({{0, -10}, {5, 9}, {-9, -3}, {9, -3}, {-5, 9}}), true, false);
  expect(fan({{10, 0},
              {1, 9},
              {-9, 3},
              {-9, -4},
              {1, -9},
              {9, 2},
              {2, 8},
              {-8, 5},
              {-9, -6},
              {2, -11}}),
         true, false);
}

TEST_F(CornerTest, three_times_round_is_no_corner) {
  expect(fan({{10, 0}, {-9, 5}, {6, -8}, {-2, 10}, {-2, -10}, {6, 8}, {-9, -5}}), true, false);
}

TEST_F(CornerTest, twice_round_with_a_side_that_comes_back_on_the_first_is_no_corner) {
  // The fourth side lies in the direction of the first, without being it.
  expect(fan({{1, 0}, {-1, 1}, {-1, -1}, {2, 0}, {-2, 1}, {-2, -3}}), true, false);
}

TEST_F(CornerTest, a_fan_that_turns_back_fails) {
  expect(fan({{1, 0}, {-1, 8}, {5, 5}, {-9, -1}, {0, -1}}), false, false);
}

TEST_F(CornerTest, a_flat_sector_fails) {
  expect(fan({{1, 0}, {-1, 0}, {0, -1}, {3, -3}}), false, false);
}

TEST_F(CornerTest, two_sectors_fail) {
  const Patch p = triangle_of({u, v, 0}, 2, numbers);
  const Patch q = triangle_of({u, v, u * v}, 2, numbers);
  const Surface s = surface({p, q}, numbers);
  EXPECT_EQ(s.seams.size(), 2);
  EXPECT_FALSE(holds(g1(s, numbers), numbers));
  EXPECT_FALSE(holds(winds_once(s, middle(s)), numbers));
}

TEST_F(CornerTest, a_patch_glued_to_itself_is_a_corner_of_one_sector_and_fails) {
  const Patch cone =
      Patch::triangle({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{1, 0, 0}, {0, 5, 1}}, {{2, 0, 0}}});
  const Surface s = surface({cone}, numbers);
  ASSERT_EQ(s.seams.size(), 1);
  ASSERT_EQ(middle(s).sectors.size(), 1);
  EXPECT_FALSE(holds(winds_once(s, middle(s)), numbers));
}

TEST_F(CornerTest, an_open_corner_carries_no_condition) {
  const Surface s = surface({flat_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0}),
                             flat_triangle({0, 0, 0}, {0, 1, 0}, {-1, 0, 0}),
                             flat_triangle({0, 0, 0}, {-1, 0, 0}, {0, -1, 0})},
                            numbers);
  EXPECT_TRUE(std::ranges::none_of(s.corners, &Corner::closed));
  EXPECT_TRUE(
      std::ranges::any_of(s.corners, [](const Corner& c) { return c.sectors.size() == 3; }));
  EXPECT_TRUE(holds(g1(s, numbers), numbers));
}

TEST_F(CornerTest, squares_and_triangles_mix) {
  const Surface s = surface({flat_square({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}),
                             flat_triangle({0, 1, 0}, {-2, -1, 0}, {0, 0, 0}),
                             flat_triangle({0, 0, 0}, {1, 0, 0}, {-2, -1, 0})},
                            numbers);
  EXPECT_EQ(middle(s).sectors.size(), 3);
  EXPECT_TRUE(holds(g1(s, numbers), numbers));
}

TEST_F(CornerTest, sectors_follow_one_another_through_their_seams) {
  const Surface s = fan({{1, 0}, {1, 3}, {-2, 1}, {-2, -1}, {1, -3}}, 5);
  const auto& sectors = middle(s).sectors;
  for (std::size_t k = 0; k < sectors.size(); ++k) {
    const auto &here = sectors[k], &next = sectors[(k + 1) % sectors.size()];
    EXPECT_TRUE(std::ranges::any_of(s.seams, [&](const Seam& seam) {
      const bool forth = seam.patch == here.patch && seam.side == here.side_out &&
                         seam.other_patch == next.patch && seam.other_side == next.side_in;
      const bool back = seam.patch == next.patch && seam.side == next.side_in &&
                        seam.other_patch == here.patch && seam.other_side == here.side_out;
      return (forth || back) && (here.out_starts_here == next.in_starts_here) == !seam.reversed;
    }));
  }
}

}  // namespace
}  // namespace seam::geometry
