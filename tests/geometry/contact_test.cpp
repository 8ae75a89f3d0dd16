// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/contact.h"

#include <gtest/gtest.h>

#include "nets.h"
#include "truth.h"

namespace seam::geometry {
namespace {

using namespace testing;

// Most pairs share the side x = 0, y in [0,1]: p at x < 0, q at x > 0, v running away from it.
class ContactTest : public ::testing::Test {
 protected:
  Patch left(const Formula& height) const {  // height in u, v with x = -v, y = u
    return square_of({-v, u, height}, 3, 3, numbers);
  }
  Patch right(const Formula& height) const { return square_of({v, u, height}, 3, 3, numbers); }

  using Along = Proposition (*)(const Contact&);
  bool meet(const Patch& p, const Patch& q, Along condition) const {
    return holds(along_a_common_side(p, q, condition, search).proposition, numbers);
  }
  bool is_g0(const Patch& p, const Patch& q) const { return meet(p, q, g0); }
  bool is_g1(const Patch& p, const Patch& q) const { return meet(p, q, g1); }
  bool is_g2(const Patch& p, const Patch& q) const { return meet(p, q, g2); }

  symbolic::Numbers numbers;
  const Search search{numbers, [this](const Formula& f) { return vanishes(f, numbers); }, {}};
  const Patch unit = flat_square({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  const Patch next = flat_square({1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0});
};

TEST_F(ContactTest, flat_neighbours_are_g2_however_they_are_parametrised) {
  for (const Patch& p : parametrisations(unit))
    for (const Patch& q : parametrisations(next)) EXPECT_TRUE(is_g2(p, q));
}

TEST_F(ContactTest, a_triangle_and_a_square_can_be_g2) {
  for (const Patch& q : parametrisations(flat_triangle({1, 0, 0}, {3, 2, 0}, {1, 1, 0}))) {
    EXPECT_TRUE(is_g2(unit, q));
    EXPECT_TRUE(is_g2(q, unit));
  }
}

TEST_F(ContactTest, sides_of_different_degree_can_be_one_curve) {
  EXPECT_TRUE(is_g2(elevate(unit, 3), next));
}

TEST_F(ContactTest, patches_without_a_common_side_are_not_g0) {
  EXPECT_FALSE(is_g0(unit, flat_square({2, 0, 0}, {3, 0, 0}, {3, 1, 0}, {2, 1, 0})));
  const Formula a_little = ratio(1, 1000000000000);
  EXPECT_FALSE(is_g0(unit, flat_square({1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1 + a_little, 0})));
}

TEST_F(ContactTest, half_a_side_is_not_a_side) {
  EXPECT_FALSE(is_g0(unit, flat_square({1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, ratio(1, 2), 0})));
}

TEST_F(ContactTest, the_same_curve_at_another_speed_is_not_g0) {
  const Patch fast = square_of({1 + u, ratio(1, 2) * v * (1 + v), 0}, 1, 2, numbers);
  EXPECT_FALSE(is_g0(unit, fast));
}

TEST_F(ContactTest, a_crease_is_g0_alone) {
  const Patch wall = flat_square({1, 0, 0}, {1, 0, 1}, {1, 1, 1}, {1, 1, 0});
  EXPECT_TRUE(is_g0(unit, wall));
  EXPECT_FALSE(is_g1(unit, wall));
}

TEST_F(ContactTest, a_fold_is_not_g1) {
  const Patch back = flat_square({1, 0, 0}, {-3, 0, 0}, {-3, 1, 0}, {1, 1, 0});
  EXPECT_TRUE(is_g0(unit, back));
  for (const Patch& q : parametrisations(back)) EXPECT_FALSE(is_g1(unit, q));
}

TEST_F(ContactTest, a_patch_is_folded_onto_itself) {
  EXPECT_TRUE(is_g0(unit, unit));
  EXPECT_FALSE(is_g1(unit, unit));
}

TEST_F(ContactTest, a_fold_at_part_of_the_side_is_not_g1) {
  // Flat; its lines u = constant start to the right at u < 1/2 and to the left at u > 1/2.
  EXPECT_FALSE(is_g1(left(0), square_of({(1 - 2 * u) * v + v * v, u, 0}, 1, 2, numbers)));
}

TEST_F(ContactTest, a_cusp_at_one_end_is_not_g1) {
  EXPECT_FALSE(is_g1(left(0), square_of({u * v + v * v, u, 0}, 1, 2, numbers)));
  EXPECT_FALSE(
      is_g1(left(0), square_of({(1 - u) * v, u, 0}, 1, 1, numbers)));  // a point for a side
}

TEST_F(ContactTest, a_direction_that_runs_along_the_side_at_one_end_is_not_g1) {
  EXPECT_FALSE(is_g1(left(0), square_of({u * v + v * v, u + v, 0}, 1, 2, numbers)));
}

TEST_F(ContactTest, a_side_that_halts_at_its_end_is_not_g1) {
  const Patch p = square_of({-v, u * u, 0}, 2, 1, numbers);
  EXPECT_FALSE(is_g1(p, square_of({v, u * u, 0}, 2, 1, numbers)));
}

TEST_F(ContactTest, tangent_planes_may_not_differ_at_a_single_parameter) {
  EXPECT_TRUE(is_g1(left(0), right(v * v)));
  EXPECT_FALSE(is_g1(left(0), right(u * (1 - u) * v + v * v)));
}

TEST_F(ContactTest, a_jump_of_curvature_is_g1_and_not_g2) {
  EXPECT_TRUE(is_g1(left(0), right(v * v)));
  EXPECT_FALSE(is_g2(left(0), right(v * v)));
  EXPECT_FALSE(is_g2(left(0), right(ratio(1, 1000000) * u * v * v)));
}

TEST_F(ContactTest, third_derivatives_do_not_matter_for_g2) {
  EXPECT_TRUE(is_g2(left(v * v), right(v * v + v * v * v)));
}

TEST_F(ContactTest, twist_is_seen_by_g1_already) {
  EXPECT_FALSE(is_g1(left(0), right(u * v)));
  EXPECT_TRUE(is_g2(left(-u * v), right(u * v)));
}

TEST_F(ContactTest, g2_does_not_depend_on_parameters) {
  // z = x^2 + 3xy + 2y^2 on either side, with lines that leave aslant and bent.
  const auto on_surface = [&](const Formula& x, const Formula& y, int m, int n) {
    return square_of({x, y, x * x + 3 * x * y + 2 * y * y}, m, n, numbers);
  };
  const Patch p = on_surface(-v, u, 2, 2);
  const Patch q = on_surface(v * (1 + u) + v * v, u + 2 * v - u * v, 2, 4);
  EXPECT_TRUE(is_g2(p, q));
  for (const Patch& other : parametrisations(q)) EXPECT_TRUE(is_g2(other, p));
}

TEST_F(ContactTest, patches_may_hold_parameters) {
  const Formula c = Formula::symbol("c");
  const Patch p = square_of({-v, u, c * u - c * v}, 1, 1, numbers);
  const Patch q = square_of({v, u, c * u + c * v}, 1, 1, numbers);
  const Criterion g = along_a_common_side(p, q, Along(g1), search);
  ASSERT_EQ(g.proposition.kind, Proposition::Kind::all);
  EXPECT_TRUE(is_g0(p, q));
  EXPECT_FALSE(is_g0(p, square_of({v, u, c * u * u}, 2, 1, numbers)));
}

TEST_F(ContactTest, a_failure_refutes_where_no_other_sides_can_meet) {
  using Failure = Criterion::Failure;
  const Formula c = Formula::symbol("c");
  const auto failure = [&](const Formula& third,
                           const decltype(Search::samples)& samples = {}) {
    const Patch p = flat_triangle({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
    const Patch q = flat_triangle({0, 0, 0}, {1, 0, 0}, {0, third, 0});
    return along_a_common_side(p, q, Along(g1), {numbers, search.vanishes, samples}).failure;
  };
  EXPECT_EQ(failure(-1), Failure::refutes);
  EXPECT_EQ(failure(1), Failure::refutes);
  EXPECT_EQ(failure(c), Failure::refutes_by_identities);  // at c = 1 all three sides meet
  EXPECT_EQ(failure(c, {{{"c", 2}}}), Failure::refutes);  // folded there
  EXPECT_EQ(failure(c, {{{"c", -2}}}), Failure::refutes_by_identities);
}

TEST_F(ContactTest, sides_that_meet_for_single_values_do_not_meet) {
  const Formula c = Formula::symbol("c");
  const Patch shifted = flat_square({1, c, 0}, {2, c, 0}, {2, 1 + c, 0}, {1, 1 + c, 0});
  const Criterion g = along_a_common_side(unit, shifted, Along(g0), search);
  EXPECT_FALSE(holds(g.proposition, numbers));
  EXPECT_EQ(g.failure, Criterion::Failure::refutes);
}

TEST_F(ContactTest, regular_means_a_normal_everywhere) {
  EXPECT_TRUE(holds(regular(unit), numbers));
  EXPECT_FALSE(holds(regular(square_of({u, u * v, 0}, 1, 1, numbers)), numbers));
  EXPECT_FALSE(holds(regular(triangle_of({u * u, v, 0}, 2, numbers)), numbers));
}

TEST_F(ContactTest, planar_looks_at_every_point) {
  EXPECT_TRUE(holds(planar({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {5, 7, 0}}), numbers));
  EXPECT_FALSE(holds(planar({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 1}}), numbers));
  EXPECT_FALSE(holds(planar({{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}), numbers));
  EXPECT_TRUE(holds(planar({{1, 2, 3}, {4, 5, 7}, {6, 6, 6}}), numbers));
  EXPECT_TRUE(holds(planar({}), numbers));
}

}  // namespace
}  // namespace seam::geometry
