// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/group.h"

#include <algorithm>

#include "geometry/frame.h"
#include "geometry/nearness.h"

// An orthogonal map of space is known from the images of two vertices that are not parallel,
// and from whether it mirrors. So all pairs of vertices are tried as images that have the dot
// products of the pair chosen: finitely many, and every symmetry is among them. One is kept if
// it is orthogonal and carries every vertex to a vertex, decided exactly; being injective, it
// then permutes them.

namespace seam::geometry {
namespace {

bool permutes(const Matrix& m, const std::vector<Point>& vertices, const PointIndex& index) {
  return std::ranges::all_of(
      vertices, [&](const Point& vertex) { return index.find(m * vertex).has_value(); });
}

bool is_identity(const Matrix& m, const Numbers& numbers) {
  return std::ranges::equal(m.rows, identity(3).rows, [&](const Point& a, const Point& b) {
    return equal(a, b, numbers);
  });
}

std::vector<Matrix> group(const Mesh& mesh, bool with_reflections, Numbers& numbers) {
  const std::vector<Point> vertices = distinct(mesh.vertices, numbers);
  const PointIndex index(vertices, numbers);
  const auto frame = Frame::of(vertices, numbers);
  if (!frame)
    throw symbolic::NumberError(
        "the vertices lie on one line through the origin: their symmetries are not finite in "
        "number");

  std::vector<Matrix> result;
  for (const bool mirrored : {false, true}) {
    if (mirrored && !with_reflections) break;
    for (const auto& [i, j] : frame->images(vertices, numbers)) {
      Matrix m = frame->carry(vertices[i], vertices[j], mirrored, numbers);
      if (permutes(m, vertices, index)) result.push_back(std::move(m));
    }
  }
  const auto unit =
      std::ranges::find_if(result, [&](const Matrix& m) { return is_identity(m, numbers); });
  std::rotate(result.begin(), unit, unit + 1);
  return result;
}

}  // namespace

std::vector<Matrix> rotations(const Mesh& mesh, Numbers& numbers) {
  return group(mesh, false, numbers);
}

std::vector<Matrix> symmetries(const Mesh& mesh, Numbers& numbers) {
  return group(mesh, true, numbers);
}

}  // namespace seam::geometry
