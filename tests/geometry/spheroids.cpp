// SPDX-License-Identifier: GPL-3.0-or-later
#include "spheroids.h"

namespace seam::geometry::testing {
namespace {

Formula f(long numerator, long denominator) {
  exact::Rational value(numerator, denominator);
  value.canonicalize();
  return Formula(value);
}

// The patch belonging to a vertex V: corners at the centroids of the faces round it, sides with
// the midpoint of the edge between two faces, raised to degree 3, the centre a multiple of V.
Patch cubic(const std::vector<Point>& corner, const std::vector<Point>& middle,
            const Point& centre) {
  const auto near_end = [](const Point& end, const Point& mid) {
    return f(1, 3) * end + f(2, 3) * mid;
  };
  const Point &a = corner[0], &b = corner[1], &c = corner[2];
  const Point &ab = middle[0], &bc = middle[1], &ca = middle[2];
  return Patch::triangle({{a, near_end(a, ab), near_end(b, ab), b},
                          {near_end(a, ca), centre, near_end(b, bc)},
                          {near_end(c, ca), near_end(c, bc)},
                          {c}});
}

}  // namespace

Patch tetroid_patch() {
  return cubic({{3, -3, -3}, {-3, 3, -3}, {-3, -3, 3}}, {{0, 0, -9}, {-9, 0, 0}, {0, -9, 0}},
               {-11, -11, -11});
}

Patch hexoid_patch() {
  return Patch::square({{{-2, -2, 2}, {0, -3, 3}, {2, -2, 2}},
                        {{-3, 0, 3}, {0, 0, 7}, {3, 0, 3}},
                        {{-2, 2, 2}, {0, 3, 3}, {2, 2, 2}}});
}

Patch octoid_patch() {
  return Patch::triangle({{{0, 0, 3}, {0, 2, 3}, {0, 3, 2}, {0, 3, 0}},
                          {{2, 0, 3}, {3, 3, 3}, {2, 3, 0}},
                          {{3, 0, 2}, {3, 2, 0}},
                          {{3, 0, 0}}});
}

// V = (1, 1, 1) of the dodecahedron, everything times 30.
Patch icosoid_patch(Numbers& numbers) {
  const Formula t = f(1, 2) * (numbers.sqrt(5) + 1), g = 35 - 3 * numbers.sqrt(5);
  const Formula far = 6 + 18 * t, near = 12 + 6 * t;  // corners: along (0, 1, t)
  return cubic(
      {{0, near, far}, {far, 0, near}, {near, far, 0}},
      {{15 * t, 15, 15 + 15 * t}, {15 + 15 * t, 15 * t, 15}, {15, 15 + 15 * t, 15 * t}},
      {g, g, g});
}

Surface tetroid(Numbers& numbers) {
  return orbit(tetroid_patch(), rotations(tetrahedron(numbers), numbers), numbers);
}

Surface hexoid(Numbers& numbers) {
  return orbit(hexoid_patch(), rotations(cube(numbers), numbers), numbers);
}

Surface octoid(Numbers& numbers) {
  return orbit(octoid_patch(), rotations(octahedron(numbers), numbers), numbers);
}

Surface icosoid(Numbers& numbers) {
  return orbit(icosoid_patch(numbers), rotations(icosahedron(numbers), numbers), numbers);
}

}  // namespace seam::geometry::testing
