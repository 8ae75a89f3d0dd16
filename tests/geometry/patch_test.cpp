// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/patch.h"

#include <gtest/gtest.h>

#include "exact/contract.h"
#include "geometry/curvature.h"
#include "nets.h"
#include "truth.h"

namespace seam::geometry {
namespace {

using namespace testing;

const Point cubic_map{u * u * v - u, v* v* v + 2 * u, 3 * u* v + v* v};
const Point mixed_map{u * u * v * v - u, v* v* v + 2 * u, 3 * u* v* v* v + v* v};

class PatchTest : public ::testing::Test {
 protected:
  void expect_equal(const Point& a, const Point& b) { EXPECT_TRUE(vanishes(a - b, numbers)); }

  symbolic::Numbers numbers;
  Patch triangle = triangle_of(cubic_map, 3, numbers);
  Patch square = square_of(mixed_map, 2, 3, numbers);
};

TEST_F(PatchTest, is_the_polynomial_of_its_net) {
  expect_equal(evaluate(triangle, u, v), cubic_map);
  expect_equal(evaluate(square, u, v), mixed_map);
  EXPECT_EQ(square.degree_u(), 2);
  EXPECT_EQ(square.degree_v(), 3);
}

TEST_F(PatchTest, first_row_is_v_0_run_by_u) {
  expect_equal(evaluate(square, 1, 0), square.rows()[0][2]);
  expect_equal(evaluate(square, 0, 1), square.rows()[3][0]);
  expect_equal(evaluate(triangle, 1, 0), triangle.rows()[0][3]);
  expect_equal(evaluate(triangle, 0, 1), triangle.rows()[3][0]);
}

TEST_F(PatchTest, derivatives_are_those_of_the_polynomial) {
  for (const auto& [i, j] :
       std::vector<std::pair<int, int>>{{1, 0}, {0, 1}, {1, 1}, {2, 1}, {0, 4}})
    for (const Patch& p : {triangle, square}) {
      Point expected = evaluate(p, u, v);
      for (Formula& x : expected) {
        for (int k = 0; k < i; ++k) x = diff(x, "u");
        for (int k = 0; k < j; ++k) x = diff(x, "v");
      }
      expect_equal(derivative(p, i, j, u, v), expected);
    }
}

TEST_F(PatchTest, derivatives_of_a_curve_are_those_of_the_polynomial) {
  const Curve curve = edge(square, 4);
  Point expected = evaluate(curve, u);
  for (Formula& x : expected) x = diff(diff(x, "u"), "u");
  expect_equal(derivative(curve, 2, u), expected);
  expect_equal(derivative(curve, 7, u), {0, 0, 0});
}

TEST_F(PatchTest, sides_are_its_boundary_curves) {
  const Formula w = 1 - u;
  expect_equal(evaluate(edge(triangle, 1), u), evaluate(triangle, u, 0));
  expect_equal(evaluate(edge(triangle, 2), u), evaluate(triangle, 0, u));
  expect_equal(evaluate(edge(triangle, 3), u), evaluate(triangle, w, u));
  expect_equal(evaluate(edge(square, 1), u), evaluate(square, u, 0));
  expect_equal(evaluate(edge(square, 2), u), evaluate(square, 0, u));
  expect_equal(evaluate(edge(square, 3), u), evaluate(square, u, 1));
  expect_equal(evaluate(edge(square, 4), u), evaluate(square, 1, u));
}

TEST_F(PatchTest, sides_run_between_the_corners_said) {
  for (const Patch& p : {triangle, square})
    for (int side = 1; side <= p.sides(); ++side) {
      const auto [from, to] = ends(p.shape(), side);
      expect_equal(edge(p, side).control.front(), corner(p, from));
      expect_equal(edge(p, side).control.back(), corner(p, to));
    }
}

TEST_F(PatchTest, along_a_side_it_is_the_same_surface) {
  const Formula w = 1 - u - v;
  expect_equal(evaluate(along(triangle, 1, true), u, v), evaluate(triangle, w, v));
  expect_equal(evaluate(along(triangle, 2, false), u, v), evaluate(triangle, v, u));
  expect_equal(evaluate(along(triangle, 2, true), u, v), evaluate(triangle, v, w));
  expect_equal(evaluate(along(triangle, 3, false), u, v), evaluate(triangle, w, u));
  expect_equal(evaluate(along(triangle, 3, true), u, v), evaluate(triangle, u, w));
  expect_equal(evaluate(along(square, 1, true), u, v), evaluate(square, 1 - u, v));
  expect_equal(evaluate(along(square, 2, false), u, v), evaluate(square, v, u));
  expect_equal(evaluate(along(square, 2, true), u, v), evaluate(square, v, 1 - u));
  expect_equal(evaluate(along(square, 3, false), u, v), evaluate(square, u, 1 - v));
  expect_equal(evaluate(along(square, 3, true), u, v), evaluate(square, 1 - u, 1 - v));
  expect_equal(evaluate(along(square, 4, false), u, v), evaluate(square, 1 - v, u));
  expect_equal(evaluate(along(square, 4, true), u, v), evaluate(square, 1 - v, 1 - u));
}

TEST_F(PatchTest, elevated_is_the_same_surface) {
  expect_equal(evaluate(elevate(triangle), u, v), cubic_map);
  expect_equal(evaluate(elevate(square), u, v), mixed_map);
  expect_equal(evaluate(elevate(square, 5), u, v), mixed_map);
  expect_equal(evaluate(elevate(edge(square, 4), 5), u), evaluate(square, 1, u));
  EXPECT_EQ(elevate(triangle).degree_u(), 4);
  EXPECT_EQ(elevate(square, 5).degree_u(), 5);
  EXPECT_EQ(elevate(square, 5).degree_v(), 5);
}

TEST_F(PatchTest, swapped_has_its_parameters_exchanged) {
  expect_equal(evaluate(swap(square), u, v), evaluate(square, v, u));
  expect_equal(evaluate(swap(triangle), u, v), evaluate(triangle, v, u));
}

TEST_F(PatchTest, rows_of_wrong_lengths_are_refused) {
  EXPECT_THROW(Patch::triangle({{{0}, {1}}, {{2}, {3}}}), exact::ContractError);
  EXPECT_THROW(Patch::triangle({{{0}, {1}}}), exact::ContractError);
  EXPECT_THROW(Patch::square({{{0}, {1}}, {{2}}}), exact::ContractError);
  EXPECT_THROW(Patch::square({{{0}, {1, 2}}}), exact::ContractError);
  EXPECT_THROW(Patch::square({}), exact::ContractError);
}

TEST_F(PatchTest, of_degree_0_is_a_point) {
  const Patch point = Patch::triangle({{{1, 2, 3}}});
  expect_equal(evaluate(point, u, v), {1, 2, 3});
  expect_equal(derivative(point, 1, 1, u, v), {0, 0, 0});
  expect_equal(evaluate(edge(elevate(point), 3), u), {1, 2, 3});
}

// Curvatures, with the values of do Carmo, 3.3.

TEST_F(PatchTest, gauss_curvature_of_a_graph) {
  const auto [numerator, denominator] =
      gauss(triangle_of({u, v, u * u + 3 * v * v}, 2, numbers), u,
            v);  // K = 12 / (1 + 4u^2 + 36v^2)^2
  expect_equal({numerator}, {12});
  expect_equal({denominator}, {power(1 + 4 * u * u + 36 * v * v, 2)});
}

TEST_F(PatchTest, gauss_curvature_of_a_saddle_is_negative_and_of_a_cylinder_0) {
  expect_equal({gauss(square_of({u, v, u * v}, 1, 1, numbers), u, v).numerator}, {-1});
  expect_equal({gauss(square_of({u, v, v * v}, 1, 2, numbers), u, v).numerator}, {0});
}

TEST_F(PatchTest, mean_curvature_of_a_graph) {
  // H = ((1 + f_v^2) f_uu - 2 f_u f_v f_uv + (1 + f_u^2) f_vv) / (2 (1 + f_u^2 + f_v^2)^(3/2))
  const auto [numerator, denominator] =
      mean_times_norm(square_of({u, v, u * u + u * v}, 2, 1, numbers), u, v);
  const Formula fu = 2 * u + v, fv = u;
  expect_equal({numerator}, {2 * (1 + fv * fv) - 2 * fu * fv});
  expect_equal({denominator}, {2 * (1 + fu * fu + fv * fv)});
}

TEST(Determinant, of_any_size) {
  symbolic::Numbers numbers;
  EXPECT_TRUE(determinant({}).is(1));
  EXPECT_TRUE(determinant({{7}}).is(7));
  EXPECT_TRUE(determinant({{1, 2}, {3, 4}}).is(-2));
  EXPECT_TRUE(determinant({{2, 0, 1}, {1, 3, 0}, {0, 1, 4}}).is(25));
  EXPECT_TRUE(determinant({{0, 0, 0, 1}, {1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}).is(-1));
}

}  // namespace
}  // namespace seam::geometry
