// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/truncation.h"

#include <gtest/gtest.h>

#include "geometry/solids.h"
#include "symbolic/numbers.h"

namespace seam::geometry {
namespace {

using exact::Rational;

const Formula quarter{Rational(1, 4)};

Mesh pyramid() {
  return {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}},
          {{3, 2, 1, 0}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}};
}

TEST(Truncation, counts_are_twice_the_edges_thrice_the_edges_and_vertices_with_faces) {
  const Mesh once = truncate(pyramid(), quarter);
  EXPECT_EQ(counts(pyramid()), (std::vector{5, 8, 5}));
  EXPECT_EQ(counts(once), (std::vector{16, 24, 10}));
  EXPECT_EQ(counts(truncate(once, quarter)), (std::vector{48, 72, 26}));
}

TEST(Truncation, faces_double_and_vertices_become_faces_of_their_valence) {
  EXPECT_EQ(face_sizes(pyramid()), (std::vector{3, 4, 4, 1}));
  EXPECT_EQ(valences(pyramid()), (std::vector{3, 4, 4, 1}));
  const Mesh once = truncate(pyramid(), quarter);
  EXPECT_EQ(face_sizes(once), (std::vector{3, 4, 4, 1, 6, 4, 8, 1}));
  EXPECT_EQ(valences(once), (std::vector{3, 16}));
}

TEST(Truncation, cuts_lie_on_the_edges_near_the_first_end_of_their_side) {
  Numbers numbers;
  const Mesh once = truncate(pyramid(), quarter);  // side 0 goes from vertex 3 to vertex 2
  EXPECT_TRUE(numbers.equal(once.vertices[0], {quarter, 1, 0}));
  EXPECT_EQ(once.faces[0].size(), 8);
  EXPECT_EQ(once.faces[0][0], 0);
}

TEST(Truncation, the_result_is_an_oriented_manifold) {
  Numbers numbers;
  Mesh mesh = dodecahedron(numbers);
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(not_oriented_manifold(mesh), "");
    mesh = truncate(mesh, quarter);
  }
  EXPECT_EQ(counts(mesh), (std::vector{540, 810, 272}));
}

TEST(Truncation, remembers_what_was_truncated) {
  const Mesh twice = truncate(truncate(pyramid(), quarter), quarter);
  ASSERT_TRUE(twice.base);
  EXPECT_EQ(twice.base->faces, pyramid().faces);
  EXPECT_EQ(twice.ratios.size(), 2);
}

TEST(Truncation, makes_every_mesh_trivalent) {
  EXPECT_FALSE(is_trivalent(pyramid()));
  EXPECT_TRUE(is_trivalent(truncate(pyramid(), quarter)));
}

TEST(Truncation, a_mesh_with_a_hole_is_no_manifold) {
  Mesh open = pyramid();
  open.faces.pop_back();
  EXPECT_NE(not_oriented_manifold(open).find("is on one face only"), std::string::npos);
}

TEST(Truncation, a_vertex_on_no_face_is_told) {
  Mesh loose = pyramid();
  loose.vertices.push_back({7, 7, 7});
  EXPECT_EQ(not_oriented_manifold(loose), "vertex 6 is on no face");
}

TEST(Truncation, two_solids_at_one_vertex_are_no_manifold) {
  Mesh mesh = pyramid();
  for (int k = 0; k < 4; ++k) mesh.vertices.push_back({-k, k * k, 5});
  for (const auto& face : pyramid().faces) {
    mesh.faces.emplace_back();
    for (const int v : face) mesh.faces.back().push_back(v == 4 ? 4 : v + 5);
  }
  EXPECT_EQ(not_oriented_manifold(mesh), "the faces round vertex 5 are not one cycle");
}

}  // namespace
}  // namespace seam::geometry
