// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solids.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

#include "geometry/nearness.h"

// A face of a Platonic solid consists of the vertices farthest out in the direction of a vertex
// of its dual. Here the solids are aligned with their duals, so those directions are at hand:
// face i belongs to vertex i of the dual. For these few fixed numbers the distances in question
// differ by more than 1/2 and the angles round a face by more than 1, so doubles see which is
// which.

namespace seam::geometry {
namespace {

using Points = std::vector<Point>;

Points opposite(const Points& points) {
  Points result;
  for (const Point& point : points) result.push_back(-1 * point);
  return result;
}

Points tetrahedron_vertices() {
  return {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
}

Points cube_vertices() {
  Points result;
  for (const int x : {1, -1})
    for (const int y : {1, -1})
      for (const int z : {1, -1}) result.push_back({x, y, z});
  return result;
}

// (0, ±a, ±b) and its cyclic permutations.
Points cyclic(const Formula& a, const Formula& b) {
  Points result;
  for (int turn = 0; turn < 3; ++turn)
    for (const int sign_a : {1, -1})
      for (const int sign_b : {1, -1}) {
        Point point{0, sign_a * a, sign_b * b};
        std::ranges::rotate(point, point.begin() + (3 - turn) % 3);
        result.push_back(std::move(point));
      }
  return result;
}

Points octahedron_vertices() {
  Points result;
  for (int axis = 0; axis < 3; ++axis)
    for (const int sign : {1, -1}) {
      result.emplace_back(3);
      result.back()[axis] = sign;
    }
  return result;
}

Formula golden_ratio(Numbers& numbers) {
  return Formula(exact::Rational(1, 2)) * (1 + numbers.sqrt(5));
}

Points dodecahedron_vertices(Numbers& numbers) {
  const Formula phi = golden_ratio(numbers);
  Points result = cube_vertices();
  for (Point& point : cyclic(phi, phi - 1))
    result.push_back(std::move(point));  // 1/phi = phi - 1
  return result;
}

Points icosahedron_vertices(Numbers& numbers) {
  return cyclic(1, golden_ratio(numbers));
}

double triple(const Approximation& a, const Approximation& b, const Approximation& c) {
  return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
         a[2] * (b[0] * c[1] - b[1] * c[0]);
}

// The vertices farthest out in the direction n, counterclockwise about it, the lowest index
// first.
std::vector<int> face_towards(const Approximation& n,
                              const std::vector<Approximation>& vertices) {
  double top = 0;
  for (const Approximation& x : vertices) top = std::max(top, dot(n, x));
  std::vector<int> face;
  for (int i = 0; i < std::ssize(vertices); ++i)
    if (near(dot(n, vertices[i]), top)) face.push_back(i);

  Approximation start = vertices[face[0]];  // from the axis to the first vertex
  for (int k = 0; k < 3; ++k) start[k] -= top / dot(n, n) * n[k];
  const auto turn = [&](int i) {  // 0 at the first vertex, then rising to 2 pi
    const double length = std::sqrt(dot(n, n));
    const double angle =
        std::atan2(triple(n, start, vertices[i]) / length, dot(start, vertices[i]));
    return angle < -0.1 ? angle + 2 * std::numbers::pi : angle;
  };
  std::ranges::sort(face, {}, turn);
  return face;
}

Mesh solid(Points vertices, const Points& dual_vertices, const Numbers& numbers) {
  const auto approximations = approximate(vertices, numbers);
  Mesh mesh{std::move(vertices), {}};
  for (const Approximation& n : approximate(dual_vertices, numbers))
    mesh.faces.push_back(face_towards(n, approximations));
  return mesh;
}

}  // namespace

Mesh tetrahedron(Numbers& numbers) {
  return solid(tetrahedron_vertices(), opposite(tetrahedron_vertices()), numbers);
}

Mesh cube(Numbers& numbers) {
  return solid(cube_vertices(), octahedron_vertices(), numbers);
}

Mesh octahedron(Numbers& numbers) {
  return solid(octahedron_vertices(), cube_vertices(), numbers);
}

Mesh dodecahedron(Numbers& numbers) {
  return solid(dodecahedron_vertices(numbers), icosahedron_vertices(numbers), numbers);
}

Mesh icosahedron(Numbers& numbers) {
  return solid(icosahedron_vertices(numbers), dodecahedron_vertices(numbers), numbers);
}

}  // namespace seam::geometry
