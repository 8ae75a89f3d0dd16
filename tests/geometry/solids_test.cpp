// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solids.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/group.h"
#include "geometry/motion.h"
#include "truth.h"

namespace seam::geometry {
namespace {

using namespace testing;
using symbolic::Numbers;

struct Solid {
  Mesh (*make)(Numbers&);
  int vertices, edges, faces, valence, rotations;
  Mesh (*dual)(Numbers&);
};

class SolidTest : public ::testing::TestWithParam<Solid> {
 protected:
  Numbers numbers;
  Mesh mesh = GetParam().make(numbers);
};

TEST_P(SolidTest, has_the_right_counts) {
  EXPECT_EQ(mesh.vertices.size(), GetParam().vertices);
  EXPECT_EQ(edges(mesh).size(), GetParam().edges);
  EXPECT_EQ(faces(mesh).size(), GetParam().faces);
  for (int vertex = 0; vertex < GetParam().vertices; ++vertex) {
    EXPECT_EQ(valence(mesh, vertex), GetParam().valence);
    EXPECT_EQ(find_vertex(mesh, mesh.vertices[vertex], numbers), vertex);
  }
  EXPECT_EQ(find_vertex(mesh, {0, 0, 0}, numbers), std::nullopt);
}

TEST_P(SolidTest, has_flat_faces_counterclockwise_from_outside_with_all_vertices_below) {
  for (const Face& face : faces(mesh)) {
    const Point n = cross(face[1] - face[0], face[2] - face[1]);
    EXPECT_EQ(numbers.sign(dot(n, face[0])), exact::Sign::positive);
    std::size_t on_plane = 0;
    for (const Point& x : mesh.vertices) {
      const exact::Sign side = numbers.sign(dot(n, x - face[0]));
      EXPECT_NE(side, exact::Sign::positive);
      if (side == exact::Sign::zero) ++on_plane;
    }
    EXPECT_EQ(on_plane, face.size());
    for (std::size_t k = 0; k < face.size(); ++k) {  // turns left at every vertex
      const Point &a = face[k], &b = face[(k + 1) % face.size()],
                  &c = face[(k + 2) % face.size()];
      EXPECT_EQ(numbers.sign(dot(n, cross(b - a, c - b))), exact::Sign::positive);
    }
  }
}

TEST_P(SolidTest, has_edges_of_one_length) {
  const auto all = edges(mesh);
  for (const MeshEdge& edge : all)
    EXPECT_TRUE(numbers.equal(norm2(edge[1] - edge[0]), norm2(all[0][1] - all[0][0])));
}

TEST_P(SolidTest, runs_through_every_edge_once_each_way) {
  std::set<std::pair<int, int>> seen;
  for (const auto& face : mesh.faces)
    for (std::size_t k = 0; k < face.size(); ++k)
      EXPECT_TRUE(seen.insert({face[k], face[(k + 1) % face.size()]}).second);
  for (const auto& [a, b] : seen) EXPECT_TRUE(seen.contains({b, a}));
}

TEST_P(SolidTest, is_dual_to_its_dual_and_aligned_with_it) {
  const Mesh other = dual(mesh, numbers), expected = GetParam().dual(numbers);
  EXPECT_EQ(edges(other).size(), edges(mesh).size());
  ASSERT_EQ(other.vertices.size(), expected.vertices.size());
  for (const Point& x : other.vertices)
    EXPECT_TRUE(std::ranges::any_of(expected.vertices, [&](const Point& y) {
      const bool tetrahedral = mesh.vertices.size() == 4;  // dual to itself turned over
      return vanishes(cross(x, y), numbers) &&
             numbers.sign(dot(x, y)) ==
                 (tetrahedral ? exact::Sign::negative : exact::Sign::positive);
    }));
  const Mesh back = dual(other, numbers);
  EXPECT_EQ(back.faces, mesh.faces);
}

TEST_P(SolidTest, has_its_group) {
  const auto turns = rotations(mesh, numbers), all = symmetries(mesh, numbers);
  EXPECT_EQ(turns.size(), GetParam().rotations);
  EXPECT_EQ(all.size(), 2 * GetParam().rotations);
  const Matrix unit = identity(3);
  EXPECT_TRUE(std::ranges::equal(turns[0].rows, unit.rows, [&](const Point& a, const Point& b) {
    return numbers.equal(a, b);
  }));
  for (const Matrix& m : all) {
    const Matrix product = transpose(m) * m;
    for (int k = 0; k < 3; ++k) EXPECT_TRUE(numbers.equal(product.rows[k], unit.rows[k]));
  }
  for (const Matrix& m : turns) EXPECT_TRUE(numbers.equal(determinant(m.rows), 1));
  std::set<std::string> different;
  for (const Matrix& m : all) {
    std::string name;
    for (const Point& row : m.rows)
      for (const Formula& x : row) name += text(numbers.normal_form(x)) + " ";
    different.insert(name);
  }
  EXPECT_EQ(different.size(), all.size());
}

INSTANTIATE_TEST_SUITE_P(All, SolidTest,
                         ::testing::Values(Solid{tetrahedron, 4, 6, 4, 3, 12, tetrahedron},
                                           Solid{cube, 8, 12, 6, 3, 24, octahedron},
                                           Solid{octahedron, 6, 12, 8, 4, 24, cube},
                                           Solid{dodecahedron, 20, 30, 12, 3, 60, icosahedron},
                                           Solid{icosahedron, 12, 30, 20, 5, 60,
                                                 dodecahedron}));

TEST(Group, of_a_box_is_smaller) {
  Numbers numbers;
  Mesh box = cube(numbers);
  for (Point& x : box.vertices) x = {x[0], x[1], 2 * x[2]};
  EXPECT_EQ(rotations(box, numbers).size(), 8);
  for (Point& x : box.vertices) x = {x[0], numbers.sqrt(2) * x[1], x[2]};
  EXPECT_EQ(rotations(box, numbers).size(), 4);
  EXPECT_EQ(symmetries(box, numbers).size(), 8);
}

TEST(Group, of_a_flat_square_is_that_of_a_flat_prism) {
  Numbers numbers;
  const Mesh square{{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2, 3}}};
  EXPECT_EQ(rotations(square, numbers).size(), 8);
  EXPECT_EQ(symmetries(square, numbers).size(), 16);
}

TEST(Group, does_not_mind_a_vertex_named_twice) {
  Numbers numbers;
  Mesh twice = cube(numbers);
  twice.vertices.push_back(twice.vertices[3]);
  EXPECT_EQ(rotations(twice, numbers).size(), 24);
}

TEST(Group, of_points_on_a_line_is_refused) {
  Numbers numbers;
  EXPECT_THROW(rotations({{{1, 1, 1}, {-1, -1, -1}}, {}}, numbers), symbolic::NumberError);
  EXPECT_THROW(rotations({}, numbers), symbolic::NumberError);
}

TEST(Mesh, vertices_on_the_rim_have_no_dual_face) {
  Numbers numbers;
  const Mesh fan{{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {-1, -1, 0}},
                 {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}};
  EXPECT_EQ(dual(fan, numbers).faces, (std::vector<std::vector<int>>{{0, 1, 2}}));
}

TEST(Motion, a_mirror_image_is_as_far_beyond_the_plane) {
  Numbers numbers;
  const Formula share(exact::Rational(1, 4));
  const Point image = reflect({5, 1, 7}, {0, 0, 2}, 6, share);  // in the plane z = 3
  EXPECT_TRUE(numbers.equal(image, {5, 1, -1}));
}

TEST(Motion, a_rotation_turns_counterclockwise_and_keeps_the_axis) {
  Numbers numbers;
  const Matrix turn = rotation({0, 0, 3}, 0, 1, numbers);  // a right angle
  EXPECT_TRUE(numbers.equal(turn * Point{1, 0, 5}, {0, 1, 5}));
  const Formula half(exact::Rational(1, 2));
  const Matrix third = rotation({1, 1, 1}, -half, half * numbers.sqrt(3), numbers);
  EXPECT_TRUE(numbers.equal(third * Point{1, 2, 3}, {3, 1, 2}));
  EXPECT_THROW(rotation({0, 0, 0}, 1, 0, numbers), symbolic::NumberError);
}

}  // namespace
}  // namespace seam::geometry
