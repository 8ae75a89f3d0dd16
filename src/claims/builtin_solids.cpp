// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/builtin.h"
#include "geometry/truncation.h"

namespace seam::claims {

using symbolic::Point;

void require_in_space(const Point& point, const Expression& at, const char* what) {
  if (point.size() != 3)
    fail(at, std::string("expected ") + what + " in space, with three coordinates");
  for (const Formula& entry : point)
    if (!symbolic::is_number(entry))
      throw Unsupported(std::string(what) + " that hold variables are not covered yet");
}

static void require_in_space(const geometry::Patch& patch, const Expression& at) {
  for (const auto& row : patch.rows())
    for (const Point& point : row) require_in_space(point, at, "patches of surfaces");
}

geometry::Surface glue(std::vector<geometry::Patch> patches, const Expression& at,
                       const Numbers& numbers) {
  for (const geometry::Patch& patch : patches) require_in_space(patch, at);
  return geometry::surface(std::move(patches), numbers);
}

geometry::Mesh solid(geometry::Mesh mesh, const Expression& at) {
  for (const Point& vertex : mesh.vertices) require_in_space(vertex, at, "vertices of solids");
  return mesh;
}

namespace {

using geometry::Mesh;
using geometry::Patch;
using geometry::Surface;

Mesh mesh(const Call& call, std::size_t i = 0) {
  return call.get<Mesh>(i, "a solid");
}

List list_of(const std::vector<Point>& points, Numbers& numbers) {
  List list;
  for (const Point& point : points) list.items.push_back(vector_value(point, numbers));
  return list;
}

List list_of(const std::vector<std::vector<Point>>& groups, Numbers& numbers) {
  List list;
  for (const auto& group : groups) list.items.push_back({list_of(group, numbers)});
  list.distinct = true;
  return list;
}

Value vertices(const Call& call) {
  List list = list_of(mesh(call).vertices, call.evaluator.numbers);
  list.distinct = true;
  return {list};
}
Value edges(const Call& call) {
  return {list_of(geometry::edges(mesh(call)), call.evaluator.numbers)};
}
Value faces(const Call& call) {
  return {list_of(geometry::faces(mesh(call)), call.evaluator.numbers)};
}

// The mean of the points; of a solid, of its vertices.
Value centroid(const Call& call) {
  const Value value = call.value(0);
  const auto points =
      value.as<Mesh>() ? value.as<Mesh>()->vertices : as_points(call.evaluator, value, call[0]);
  if (points.empty()) fail(call[0], "no points");
  Numbers& numbers = call.evaluator.numbers;
  return vector_value(geometry::centroid(points, numbers), numbers);
}

Value midpoint(const Call& call) {
  std::vector<Point> ends;
  if (call.count() == 2) {
    ends = {as_point(call.evaluator, call.value(0), call[0]),
            as_point(call.evaluator, call.value(1), call[1])};
  } else {
    ends = as_points(call.evaluator, call.value(0), call[0]);
  }
  if (ends.size() != 2 || ends[0].size() != ends[1].size())
    fail(call.at, "expected two points");
  Numbers& numbers = call.evaluator.numbers;
  return vector_value(geometry::centroid(ends, numbers), numbers);
}

Value dual(const Call& call) {
  const Mesh m = mesh(call);
  if (const std::string fault = geometry::not_oriented_manifold(m); !fault.empty())
    fail(call[0], "this mesh has no dual: " + fault,
         "that takes a closed mesh whose faces are turned alike");
  return {geometry::dual(m, call.evaluator.numbers)};
}

Value scale(const Call& call) {
  return arithmetic(call.evaluator, call.at, "*", {Scalar(call.number(0))}, call.value(1));
}

Value group(const std::vector<geometry::Matrix>& matrices) {
  List list;
  for (const auto& matrix : matrices) {
    MatrixValue value;
    for (const Point& row : matrix.rows) value.rows.emplace_back(row.begin(), row.end());
    list.items.push_back({value});
  }
  return {list};
}

Value rotations(const Call& call) {
  return group(geometry::rotations(mesh(call), call.evaluator.numbers));
}
Value symmetries(const Call& call) {
  return group(geometry::symmetries(mesh(call), call.evaluator.numbers));
}

Value orbit(const Call& call) {
  const Patch patch = call.get<Patch>(0, "a patch");
  require_in_space(patch, call[0]);
  std::vector<geometry::Matrix> matrices;
  for (const Value& item : as_items(call.evaluator, call.value(1), call[1])) {
    matrices.push_back(as_matrix(call.evaluator, item, call[1]));
    if (matrices.back().rows.size() != 3 || matrices.back().rows[0].size() != 3)
      fail(call[1], "expected matrices of 3 rows and 3 columns");
    for (const Point& row : matrices.back().rows) require_in_space(row, call[1], "matrices");
  }
  if (matrices.empty()) fail(call[1], "no matrices");
  return {geometry::orbit(patch, matrices, call.evaluator.numbers)};
}

Value surface(const Call& call) {
  std::vector<Patch> patches;
  for (const Value& item : as_items(call.evaluator, call.value(0), call[0])) {
    const auto* patch = item.as<Patch>();
    if (!patch) fail(call[0], "expected patches, found " + description(item));
    patches.push_back(*patch);
  }
  if (patches.empty()) fail(call[0], "no patches");
  return {glue(std::move(patches), call[0], call.evaluator.numbers)};
}

Surface glued(const Call& call) {
  return call.get<Surface>(0, "a surface");
}

Value patches(const Call& call) {
  List list;
  for (const Patch& patch : glued(call).patches) list.items.push_back({patch});
  list.distinct = true;
  return {list};
}

// A seam is the pair of its patches.
Value seams(const Call& call) {
  const Surface s = glued(call);
  List list;
  for (const auto& seam : s.seams)
    list.items.push_back(
        {List{{{s.patches[seam.patch]}, {s.patches[seam.other_patch]}}, false}});
  return {list};
}

Value corners(const Call& call) {
  List list;
  for (const auto& corner : glued(call).corners)
    list.items.push_back(vector_value(corner.point, call.evaluator.numbers));
  return {list};
}

}  // namespace

const Builtins& solid_builtins() {
  static const Builtins table = {
      {"vertices", {1, 1, vertices}},     {"edges", {1, 1, edges}},
      {"faces", {1, 1, faces}},           {"centroid", {1, 1, centroid}},
      {"midpoint", {1, 2, midpoint}},     {"dual", {1, 1, dual}},
      {"scale", {2, 2, scale}},           {"rotations", {1, 1, rotations}},
      {"symmetries", {1, 1, symmetries}}, {"orbit", {2, 2, orbit}},
      {"surface", {1, 1, surface}},       {"patches", {1, 1, patches}},
      {"seams", {1, 1, seams}},           {"corners", {1, 1, corners}}};
  return table;
}

}  // namespace seam::claims
