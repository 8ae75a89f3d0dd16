// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <gtest/gtest.h>

#include <algorithm>

#include "builder.h"

namespace seam::check::test {
namespace {

using Property = Mesh::Property;

struct Meshes : Case {
  Term nil = number(0), one = number(1), two = number(2), quarter = number("1/4"),
       half = number("1/2");

  Mesh tetrahedron() {
    return {4,
            {{nil, nil, nil}, {one, nil, nil}, {nil, one, nil}, {nil, nil, one}},
            {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}},
            {},
            Property::counts,
            {}};
  }
  Finding of(Mesh mesh, Property property, std::vector<int> values = {}) {
    mesh.property = property;
    mesh.values = std::move(values);
    claim(std::move(mesh));
    return finding(Computation{});
  }
  Mesh truncated(Mesh mesh, int times) {
    mesh.ratios.assign(static_cast<std::size_t>(times), quarter);
    return mesh;
  }
};

TEST(MeshObligation, counts_are_vertices_edges_faces) {
  Meshes c;
  EXPECT_HOLDS(c.of(c.tetrahedron(), Property::counts, {4, 6, 4}));
  EXPECT_FAILS(c.of(c.tetrahedron(), Property::counts, {4, 6, 5}));
  EXPECT_EQ(c.of(c.tetrahedron(), Property::counts, {0, 0, 0}).reason,
            "4 vertices, 6 edges, 4 faces");
}

TEST(MeshObligation, truncation_trebles_the_edges) {
  Meshes c;
  EXPECT_HOLDS(c.of(c.truncated(c.tetrahedron(), 1), Property::counts, {12, 18, 8}));
  EXPECT_HOLDS(c.of(c.truncated(c.tetrahedron(), 5), Property::counts, {972, 1458, 488}));
  EXPECT_HOLDS(c.of(c.truncated(c.tetrahedron(), 1), Property::face_sizes, {3, 4, 6, 4}));
  EXPECT_FAILS(c.of(c.truncated(c.tetrahedron(), 1), Property::face_sizes, {3, 4, 6, 3}));
  EXPECT_HOLDS(c.of(c.truncated(c.tetrahedron(), 1), Property::valences, {3, 12}));
  EXPECT_HOLDS(c.of(c.truncated(c.tetrahedron(), 1), Property::valence, {11, 3}));
  EXPECT_FAILS(c.of(c.truncated(c.tetrahedron(), 1), Property::valence, {11, 4}));
}

TEST(MeshObligation, truncation_keeps_closed_oriented_manifolds_and_convexity) {
  Meshes c;
  for (const Property property :
       {Property::connected, Property::closed, Property::manifold, Property::orientable,
        Property::oriented, Property::planar, Property::convex})
    for (const int times : {0, 1, 2})
      EXPECT_HOLDS(c.of(c.truncated(c.tetrahedron(), times), property));
}

TEST(MeshObligation, a_ratio_of_a_half_or_less_than_nothing_truncates_nothing) {
  Meshes c;
  for (const Term ratio : {c.half, c.nil, c.one}) {
    Mesh mesh = c.tetrahedron();
    mesh.ratios = {ratio};
    EXPECT_OPEN(c.of(mesh, Property::counts, {12, 18, 8}), "between 0 and 1/2");
  }
}

TEST(MeshObligation, an_open_mesh_is_not_truncated) {
  Meshes c;
  Mesh mesh = c.truncated(c.tetrahedron(), 1);
  mesh.faces.pop_back();
  EXPECT_OPEN(c.of(mesh, Property::counts, {9, 13, 7}), "no oriented manifold");
}

TEST(MeshObligation, an_open_mesh_is_neither_closed_nor_a_manifold_but_orientable) {
  Meshes c;
  Mesh mesh = c.tetrahedron();
  mesh.faces.pop_back();
  EXPECT_FAILS(c.of(mesh, Property::closed));
  EXPECT_FAILS(c.of(mesh, Property::manifold));
  EXPECT_FAILS(c.of(mesh, Property::oriented));
  EXPECT_HOLDS(c.of(mesh, Property::orientable));
  EXPECT_HOLDS(c.of(mesh, Property::connected));
}

TEST(MeshObligation, a_face_turned_over_can_be_turned_back) {
  Meshes c;
  Mesh mesh = c.tetrahedron();
  mesh.faces[0] = {0, 1, 2};
  EXPECT_FAILS(c.of(mesh, Property::oriented));
  EXPECT_HOLDS(c.of(mesh, Property::orientable));
  EXPECT_HOLDS(c.of(mesh, Property::manifold));
  EXPECT_FAILS(c.of(mesh, Property::convex));
}

TEST(MeshObligation, the_projective_plane_is_a_manifold_and_not_orientable) {
  Meshes c;
  const Mesh plane{6,
                   {},
                   {{0, 1, 2},
                    {0, 2, 3},
                    {0, 3, 4},
                    {0, 4, 5},
                    {0, 5, 1},
                    {1, 2, 4},
                    {2, 3, 5},
                    {3, 4, 1},
                    {4, 5, 2},
                    {5, 1, 3}},
                   {},
                   Property::counts,
                   {}};
  EXPECT_HOLDS(c.of(plane, Property::counts, {6, 15, 10}));
  EXPECT_HOLDS(c.of(plane, Property::manifold));
  EXPECT_HOLDS(c.of(plane, Property::closed));
  EXPECT_FAILS(c.of(plane, Property::orientable));
}

TEST(MeshObligation, three_faces_at_an_edge_are_no_manifold_and_not_orientable) {
  Meshes c;
  const Mesh book{5, {}, {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, {}, Property::counts, {}};
  EXPECT_FAILS(c.of(book, Property::manifold));
  EXPECT_FAILS(c.of(book, Property::orientable));
}

TEST(MeshObligation, a_vertex_on_no_face_is_not_connected) {
  Meshes c;
  Mesh mesh = c.tetrahedron();
  mesh.vertices = 5;
  mesh.points.clear();
  EXPECT_FAILS(c.of(mesh, Property::connected));
  EXPECT_FAILS(c.of(mesh, Property::closed));
  EXPECT_FAILS(c.of(mesh, Property::manifold));
  EXPECT_HOLDS(c.of(mesh, Property::valences, {0, 1, 3, 4}));
}

TEST(MeshObligation, planar_needs_coordinates) {
  Meshes c;
  Mesh mesh = c.tetrahedron();
  mesh.points.clear();
  EXPECT_OPEN(c.of(mesh, Property::planar), "without coordinates");
  EXPECT_OPEN(c.of(mesh, Property::convex), "without coordinates");
}

TEST(MeshObligation, four_points_are_planar_exactly_if_they_are_in_one_plane) {
  Meshes c;
  Mesh mesh{4,
            {{c.nil, c.nil, c.nil},
             {c.one, c.nil, c.nil},
             {c.one, c.one, c.nil},
             {c.nil, c.one, c.nil}},
            {{0, 1, 2, 3}},
            {},
            Property::planar,
            {}};
  EXPECT_HOLDS(c.of(mesh, Property::planar));
  EXPECT_HOLDS(c.of(mesh, Property::planar, {0}));
  EXPECT_OPEN(c.of(mesh, Property::planar, {1}), "a face that is none");
  mesh.points[3][2] = c.number("1/1000000");
  EXPECT_FAILS(c.of(mesh, Property::planar));
  EXPECT_EQ(c.finding(Computation{}).reason, "face 1 is not planar");
  mesh.points[1] = {c.nil, c.nil, c.nil};  // three points, one twice
  EXPECT_HOLDS(c.of(mesh, Property::planar));
  mesh.points[3] = {c.two, c.two, c.nil};  // on one line
  EXPECT_HOLDS(c.of(mesh, Property::planar));
}

TEST(MeshObligation, a_coordinate_that_is_not_told_from_0_leaves_planarity_open) {
  Meshes c;
  const Term root = c.root("r", c.number(4), "1", "3");  // 2, though its normal form is r
  Mesh mesh{4,
            {{c.nil, c.nil, c.nil},
             {c.one, c.nil, c.nil},
             {c.one, c.one, c.nil},
             {c.nil, c.one, c.difference(root, c.two)}},
            {{0, 1, 2, 3}},
            {},
            Property::planar,
            {}};
  EXPECT_OPEN(c.of(mesh, Property::planar), "a sign could not be decided");
}

TEST(MeshObligation, a_dent_is_not_convex) {
  Meshes c;
  Mesh mesh = c.tetrahedron();  // with a pyramid on its last face, out or in
  mesh.vertices = 5;
  mesh.faces.pop_back();
  for (const auto& face : {std::vector{1, 2, 4}, {2, 3, 4}, {3, 1, 4}})
    mesh.faces.push_back(face);
  mesh.points.push_back({c.half, c.half, c.half});
  EXPECT_HOLDS(c.of(mesh, Property::convex));
  mesh.points[4] = {c.quarter, c.quarter, c.quarter};
  EXPECT_FAILS(c.of(mesh, Property::convex));
  const Term third = c.number("1/3");  // in the plane of the face that it replaces
  mesh.points[4] = {third, third, third};
  EXPECT_FAILS(c.of(mesh, Property::convex));
}

TEST(MeshObligation, two_triangles_back_to_back_are_not_convex) {
  Meshes c;
  Mesh mesh = c.tetrahedron();
  mesh.vertices = 3;
  mesh.points.pop_back();
  mesh.faces = {{0, 1, 2}, {2, 1, 0}};
  EXPECT_HOLDS(c.of(mesh, Property::closed));
  EXPECT_FAILS(c.of(mesh, Property::convex));
}

TEST(MeshObligation, the_other_sense_all_round_is_convex_too) {
  Meshes c;
  Mesh mesh = c.tetrahedron();
  for (auto& face : mesh.faces) std::reverse(face.begin(), face.end());
  EXPECT_HOLDS(c.of(mesh, Property::convex));
}

TEST(MeshObligation, faces_that_are_none_are_rejected) {
  Meshes c;
  for (const std::vector<int>& face : {std::vector{0, 1}, {0, 1, 4}, {0, 1, -1}, {0, 1, 0}}) {
    Mesh mesh = c.tetrahedron();
    mesh.faces[0] = face;
    EXPECT_OPEN(c.of(mesh, Property::counts, {4, 6, 4}), "malformed");
  }
  Mesh mesh = c.tetrahedron();
  mesh.vertices = 5;
  EXPECT_OPEN(c.of(mesh, Property::counts, {5, 6, 4}), "malformed");
}

TEST(MeshObligation, too_many_truncations_end_with_a_reason) {
  Meshes c;
  EXPECT_OPEN(c.of(c.truncated(c.tetrahedron(), 40), Property::counts, {0, 0, 0}), "effort");
  Mesh mesh = c.tetrahedron();
  mesh.points.clear();
  mesh.vertices = 2'000'000'000;
  EXPECT_OPEN(c.of(mesh, Property::connected), "effort");
}

TEST(MeshObligation, values_that_do_not_belong_to_the_property_are_not_judged) {
  Meshes c;
  EXPECT_OPEN(c.of(c.tetrahedron(), Property::counts, {4, 6}), "not as many values");
  EXPECT_OPEN(c.of(c.tetrahedron(), Property::closed, {1}), "not as many values");
  EXPECT_OPEN(c.of(c.tetrahedron(), Property::valence, {4, 3}), "a vertex that is none");
}

TEST(MeshObligation, evidence_of_another_kind_says_nothing) {
  Meshes c;
  c.of(c.tetrahedron(), Property::closed);
  EXPECT_OPEN(c.finding(Witness{}), "says nothing of a mesh");
}

}  // namespace
}  // namespace seam::check::test
