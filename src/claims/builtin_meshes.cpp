// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "claims/any_mesh.h"
#include "claims/builtin.h"
#include "geometry/truncation.h"

// What is counted on a mesh is a number; that it was counted right is stated beside.

namespace seam::claims {
namespace {

using geometry::Mesh;
using geometry::Property;
using symbolic::Point;

constexpr long most_sides = 1'000'000;
constexpr long max_times = 100;

Mesh mesh(const Call& call) {
  const Value value = call.value(0);
  if (value.as<AnyMesh>() || value.as<IteratedMesh>())
    throw Unsupported("this function of " + description(value));
  Mesh result = call.get<Mesh>(0, "a mesh");
  require_faces(result, call[0]);
  return result;
}

Value mesh_of(const Call& call) {
  Mesh result;
  result.vertices = as_points(call.evaluator, call.value(0), call[0]);
  for (const Value& face : as_items(call.evaluator, call.value(1), call[1])) {
    auto& corners = result.faces.emplace_back();
    const std::string what = "face " + std::to_string(result.faces.size());
    for (const Value& index : as_items(call.evaluator, face, call[1])) {
      const long k = as_integer(call.evaluator, index, call[1]);
      if (k < 1 || k > std::ssize(result.vertices))
        fail(call[1], what + ": there is no vertex " + std::to_string(k),
             "vertices count from 1 to " + std::to_string(result.vertices.size()));
      if (std::ranges::find(corners, k - 1) != corners.end())
        fail(call[1], what + " comes twice to vertex " + std::to_string(k));
      corners.push_back(static_cast<int>(k - 1));
    }
  }
  if (result.faces.empty()) fail(call[1], "a mesh has a face at least");
  return {solid(std::move(result), call[0])};
}

Formula ratio_of(const Call& call) {
  if (call.count() == 1) return Formula(exact::Rational(1, 4));
  const Formula ratio = call.number(1);
  const Numbers& numbers = call.evaluator.numbers;
  if (numbers.sign(ratio) != exact::Sign::positive ||
      numbers.sign(Formula(exact::Rational(1, 2)) - ratio) != exact::Sign::positive)
    fail(call[1], "a truncation cuts edges at a ratio between 0 and 1/2");
  return ratio;
}

// How often: a number, or an integer parameter with a least value.
IteratedMesh how_often(const Call& call, const Formula& ratio) {
  IteratedMesh result;
  result.ratio = ratio;
  result.least = 1;
  if (call.count() < 3) return result;
  const Scalar times = as_scalar(call.evaluator, call.value(2), call[2]);
  const auto index = as_index(call.evaluator, times);
  if (!index) fail(call[2], "expected an integer, or an integer parameter and an integer");
  result.least = index->shift;
  result.parameter = index->parameter;
  if (!index->parameter.empty()) {
    const Integers::General& range = call.evaluator.integers.general.at(index->parameter);
    if (!range.first || !range.upward)
      throw Unsupported(
          "a truncation repeated as often as an integer without a least value says");
    result.first = *range.first;
    result.least += result.first;
  }
  if (result.least < 0) fail(call[2], "expected how often, from 0 on");
  return result;
}

Mesh truncated(const Call& call, Mesh mesh, const Formula& ratio, long times) {
  if (times > max_times) fail(call[2], "truncated too often");
  for (long k = 0; k < times; ++k) {
    std::size_t sides = 0;
    for (const auto& face : mesh.faces) sides += face.size();
    if (std::cmp_greater(3 * sides, most_sides))
      fail(call.at, "this mesh would have more than half a million edges");
    mesh = geometry::truncate(mesh, ratio);
  }
  return mesh;
}

Value truncate(const Call& call) {
  const Formula ratio = ratio_of(call);
  IteratedMesh result = how_often(call, ratio);
  const bool is_general = !result.parameter.empty();
  if (const Value value = call.value(0); const auto* any = value.as<AnyMesh>()) {
    AnyMesh mesh = *any;
    if (!is_general && result.least > max_times) fail(call[2], "truncated too often");
    if (!is_general)
      for (long k = 0; k < result.least; ++k) mesh = claims::truncated(mesh);
    if (!is_general) return {mesh};
    result.mesh = mesh;
    return {result};
  }
  const Mesh base = mesh(call);
  if (const std::string fault = geometry::not_oriented_manifold(base); !fault.empty())
    fail(call[0], "this mesh cannot be truncated: " + fault,
         "that takes a closed mesh whose faces are turned alike");
  if (!is_general) return {truncated(call, base, ratio, result.least)};
  result.mesh = base;
  return {result};
}

void state(const Call& call, const Mesh& m, Property property, std::vector<int> values) {
  call.evaluator.sides.push_back(
      geometry::has(m, property, std::move(values), "counted on the mesh"));
}

// V, E, F of a mesh with three edges at each vertex after k more truncations: V 3^k, E 3^k,
// F + V (1 + 3 + ... + 3^(k - 1)).
Vector counted(const Call& call, const IteratedMesh& m) {
  AnyMesh start;
  if (const auto* any = std::get_if<AnyMesh>(&m.mesh)) {
    start = *any;
    for (long k = 0; k < m.least; ++k) start = claims::truncated(start);
  } else {
    const Mesh mesh = truncated(call, std::get<Mesh>(m.mesh), m.ratio, m.least);
    const std::vector<int> values = geometry::counts(mesh);
    start = {values[0], values[1], values[2], false, geometry::is_trivalent(mesh)};
    state(call, mesh, Property::counts, values);
    state(call, mesh, Property::valences, geometry::valences(mesh));
  }
  if (!start.trivalent)
    throw Unsupported(
        "counting on a mesh with other than three edges at a vertex, truncated as "
        "often as an integer parameter says");
  Evaluator& evaluator = call.evaluator;
  const Scalar times = Scalar(Formula::symbol(m.parameter)) - Scalar(m.first);
  const auto power = integer_power(evaluator, Scalar(3), times);
  const Scalar half{Formula(exact::Rational(1, 2))};
  return {start.vertices * *power, start.edges * *power,
          start.faces + start.vertices * (*power - Scalar(1)) * half};
}

// V, E, F.
Vector counted(const Call& call) {
  const Value value = call.value(0);
  if (const auto* any = value.as<AnyMesh>()) return {any->vertices, any->edges, any->faces};
  if (const auto* iterated = value.as<IteratedMesh>()) return counted(call, *iterated);
  const Mesh m = mesh(call);
  std::vector<int> values = geometry::counts(m);
  state(call, m, Property::counts, values);
  return Vector(values.begin(), values.end());
}

Value counts(const Call& call) {
  return {counted(call)};
}

Value euler(const Call& call) {
  const Vector values = counted(call);
  return {values[0] - values[1] + values[2]};
}

Value pairs(const std::vector<int>& values) {
  List list;
  for (std::size_t i = 0; i < values.size(); i += 2)
    list.items.push_back({Vector{Scalar(values[i]), Scalar(values[i + 1])}});
  return {list};
}

Value face_sizes(const Call& call) {
  const Mesh m = mesh(call);
  const auto values = geometry::face_sizes(m);
  state(call, m, Property::face_sizes, values);
  return pairs(values);
}

Value valences(const Call& call) {
  if (const Value value = call.value(0); const auto* any = value.as<AnyMesh>()) {
    if (!any->trivalent) throw Unsupported("the valences of an arbitrary mesh");
    return {List{{{Vector{Scalar(3), any->vertices}}}, false}};
  }
  const Mesh m = mesh(call);
  const auto values = geometry::valences(m);
  state(call, m, Property::valences, values);
  return pairs(values);
}

// The edges that end in a point; of a point that is no vertex, none.
Value valence(const Call& call) {
  const Mesh m = mesh(call);
  const Point point = as_point(call.evaluator, call.value(1), call[1]);
  require_in_space(point, call[1], "a vertex");
  const auto vertex = geometry::find_vertex(m, point, call.evaluator.numbers);
  if (!vertex) fail(call[1], "this is no vertex of the mesh");
  const int edges = geometry::valence(m, *vertex);
  state(call, m, Property::valence, {*vertex, edges});
  return {Scalar(edges)};
}

}  // namespace

void require_faces(const Mesh& mesh, const Expression& at) {
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    if (mesh.faces[f].size() < 3)
      fail(at,
           "face " + std::to_string(f + 1) + " has " + std::to_string(mesh.faces[f].size()) +
               " corners",
           "a face has three corners at least");
}

const Builtins& mesh_builtins() {
  static const Builtins table = {
      {"mesh", {2, 2, mesh_of}},     {"truncate", {1, 3, truncate}},
      {"counts", {1, 1, counts}},    {"euler", {1, 1, euler}},
      {"valence", {2, 2, valence}},  {"face_sizes", {1, 1, face_sizes}},
      {"valences", {1, 1, valences}}};
  return table;
}

}  // namespace seam::claims
