// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/surface.h"

#include <gtest/gtest.h>

#include "geometry/contact.h"
#include "nets.h"
#include "spheroids.h"
#include "truth.h"

namespace seam::geometry {
namespace {

using namespace testing;

std::vector<Patch> flat_faces(const Mesh& mesh) {
  std::vector<Patch> result;
  for (const Face& f : faces(mesh))
    result.push_back(f.size() == 3 ? flat_triangle(f[0], f[1], f[2])
                                   : flat_square(f[0], f[1], f[2], f[3]));
  return result;
}

class SurfaceTest : public ::testing::Test {
 protected:
  bool is_closed(const Surface& s) const { return holds(closed(s, numbers), numbers); }
  Surface of(std::vector<Patch> patches) const { return surface(std::move(patches), numbers); }

  symbolic::Numbers numbers;
  const std::vector<Patch> box = flat_faces(cube(numbers));
};

TEST_F(SurfaceTest, a_polyhedron_is_closed_with_its_edges_for_seams) {
  for (const Mesh& mesh :
       {tetrahedron(numbers), cube(numbers), octahedron(numbers), icosahedron(numbers)}) {
    const Surface s = of(flat_faces(mesh));
    EXPECT_EQ(s.seams.size(), edges(mesh).size());
    EXPECT_EQ(s.corners.size(), mesh.vertices.size());
    EXPECT_EQ(euler_characteristic(s), 2);
    EXPECT_TRUE(is_closed(s));
    EXPECT_FALSE(holds(g1(s, numbers), numbers));
    EXPECT_FALSE(holds(convex(s, numbers), numbers));
  }
}

TEST_F(SurfaceTest, without_one_patch_it_is_not_closed) {
  EXPECT_FALSE(is_closed(of({box.begin(), box.begin() + 5})));
}

TEST_F(SurfaceTest, with_one_patch_twice_it_is_not_closed) {
  auto patches = box;
  patches.push_back(box[2]);
  EXPECT_FALSE(is_closed(of(patches)));
  patches = box;
  patches.insert(patches.end(), box.begin(), box.end());
  EXPECT_FALSE(is_closed(of(patches)));
}

TEST_F(SurfaceTest, with_a_slit_it_is_not_closed) {
  auto patches = box;
  auto rows = elevate(box[0]).rows();
  rows[0][1][0] += ratio(1, 1000000000);
  patches[0] = Patch::square(rows);
  EXPECT_FALSE(is_closed(of(patches)));
}

TEST_F(SurfaceTest, two_closed_parts_are_not_one_closed_surface) {
  auto patches = box;
  for (const Patch& p : box)
    patches.push_back(map(p, [](const Point& x) { return x + Point{2, 2, 2}; }));
  const Surface s = of(patches);
  EXPECT_EQ(s.corners.size(), 16);  // the corner in which the parts touch is two
  EXPECT_FALSE(is_closed(s));
  EXPECT_FALSE(holds(g1(s, numbers), numbers));
}

TEST_F(SurfaceTest, parts_that_touch_along_an_edge_are_not_closed) {
  auto patches = box;
  for (const Patch& p : box)
    patches.push_back(map(p, [](const Point& x) { return x + Point{2, 2, 0}; }));
  EXPECT_FALSE(is_closed(of(patches)));
}

TEST_F(SurfaceTest, a_torus_has_euler_characteristic_0_and_is_not_convex) {
  std::vector<Patch> patches;
  const std::vector<Point> ring{{3, 0, 0}, {0, 3, 0}, {-3, -3, 0}};
  const std::vector<Point> section{{0, 0, 1}, {0, 0, -1}, {0, 0, 0}};  // and in or out
  const auto at = [&](int i, int j) {
    const Formula out = ratio(j % 3 == 2 ? 4 : 3, 3);
    return out * ring[i % 3] + section[j % 3];
  };
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      patches.push_back(flat_square(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)));
  const Surface s = of(patches);
  EXPECT_EQ(euler_characteristic(s), 0);
  EXPECT_TRUE(is_closed(s));
  EXPECT_FALSE(holds(convex(s, numbers), numbers));
}

TEST_F(SurfaceTest, seams_that_cross_in_their_middles_are_told_apart) {
  Mesh crossed = cube(numbers);  // vertices 0, 1 and 6, 7 are opposite edges
  crossed.vertices[0] = {1, 0, 0};
  crossed.vertices[1] = {-1, 0, 0};
  crossed.vertices[6] = {0, 1, 0};
  crossed.vertices[7] = {0, -1, 0};
  const Surface s = of(flat_faces(crossed));
  EXPECT_EQ(s.seams.size(), 12);
  EXPECT_TRUE(is_closed(s));
}

TEST_F(SurfaceTest, seams_are_found_far_out_and_close_by) {
  for (const Formula& size : {ratio(1, 1000000000000), Formula(1000000000000)}) {
    std::vector<Patch> patches;
    for (const Patch& p : box)
      patches.push_back(map(p, [&](const Point& x) { return size * x; }));
    EXPECT_TRUE(is_closed(of(patches)));
  }
}

TEST_F(SurfaceTest, seams_between_numbers_written_differently_are_found) {
  auto patches = box;
  const Formula one = numbers.sqrt(3) * numbers.inverse(numbers.sqrt(3));
  const Formula also_one = power(numbers.sqrt(2) + 1, 20) * power(numbers.sqrt(2) - 1, 20);
  patches[0] = map(patches[0], [&](const Point& x) { return one * x; });
  patches[1] = map(patches[1], [&](const Point& x) { return also_one * x; });
  EXPECT_TRUE(is_closed(of(patches)));
}

TEST_F(SurfaceTest, patches_without_seams_are_no_g1_surface) {
  EXPECT_FALSE(holds(g1(of({box[0], box[1]}), numbers), numbers));
  EXPECT_TRUE(holds(g1(of({box[0]}), numbers), numbers));
}

TEST_F(SurfaceTest, three_patches_on_one_side_are_not_g1) {
  const Patch p = flat_square({0, 0, 0}, {-1, 0, 0}, {-1, 1, 0}, {0, 1, 0});
  const Patch q = flat_square({0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  const Patch r = flat_square({0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0});
  EXPECT_TRUE(holds(g1(of({p, q}), numbers), numbers));
  EXPECT_FALSE(holds(g1(of({p, q, r}), numbers), numbers));
}

TEST_F(SurfaceTest, an_orbit_has_each_image_once) {
  const auto group = symmetries(cube(numbers), numbers);
  EXPECT_EQ(orbit(box[0], group, numbers).patches.size(), 6);
  EXPECT_EQ(
      orbit(flat_triangle({1, 1, 1}, {1, -1, 1}, {1, 0, 3}), group, numbers).patches.size(),
      24);
  EXPECT_EQ(orbit(flat_triangle({1, 1, 1}, {1, -1, 1}, {1, 0, 3}), {}, numbers).patches.size(),
            1);
}

TEST_F(SurfaceTest, convex_asks_for_curvature_everywhere) {
  // The octoid with its centres pressed in: still closed, no longer convex.
  auto rows = octoid_patch().rows();
  rows[1][1] = {1, 1, 1};
  const Surface s =
      orbit(Patch::triangle(rows), rotations(octahedron(numbers), numbers), numbers);
  EXPECT_TRUE(is_closed(s));
  EXPECT_FALSE(holds(convex(s, numbers), numbers));
}

TEST_F(SurfaceTest, convex_asks_for_curvature_to_one_side) {
  const Surface egg = octoid(numbers);
  EXPECT_TRUE(holds(convex(egg, numbers), numbers));
}

TEST_F(SurfaceTest, interpolates_corners_and_simple_parameters) {
  const Surface s = octoid(numbers);
  const auto corners = scale(3, octahedron(numbers)).vertices;
  EXPECT_TRUE(holds(interpolates(s, corners, numbers), numbers));
  EXPECT_TRUE(holds(
      interpolates(s, {evaluate(s.patches[3], ratio(1, 3), ratio(1, 3))}, numbers), numbers));
  EXPECT_FALSE(holds(interpolates(s, {{1, 1, 1}}, numbers), numbers));
  EXPECT_FALSE(
      holds(interpolates(s, {corners[0], {3, 0, ratio(1, 1000000000)}}, numbers), numbers));
}

}  // namespace
}  // namespace seam::geometry
