// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <map>
#include <utility>

#include "check/mesh.h"
#include "check/rules.h"

// The mesh is truncated as the statement says and looked at. What fails names its place.

namespace seam::check {
namespace {

using Property = certificate::Mesh::Property;
using Values = std::vector<int>;

void demand_size(const Values& values, std::size_t size) {
  demand(values.size() == size, "degenerate: not as many values as the property takes");
}

// How often each number occurs, by rising number, and the same in words.
struct Multiset {
  std::map<std::size_t, std::size_t> count;

  bool is(const Values& values) const {
    Values own;
    for (const auto& [number, times] : count) {
      own.push_back(static_cast<int>(number));
      own.push_back(static_cast<int>(times));
    }
    return own == values;
  }
  std::string text(const char* what, const char* before, const char* after) const {
    std::string result;
    for (const auto& [number, times] : count)
      result += (result.empty() ? what : ", ") + std::to_string(times) + " of " + before +
                std::to_string(number) + after;
    return result;
  }
};

std::string counts_differ(const Mesh& mesh, const Sides& sides, const Values& values) {
  demand_size(values, 3);
  const Values own = {static_cast<int>(mesh.vertices), static_cast<int>(sides.edges),
                      static_cast<int>(mesh.faces.size())};
  if (own == values) return {};
  return std::to_string(own[0]) + " vertices, " + std::to_string(own[1]) + " edges, " +
         std::to_string(own[2]) + " faces";
}

std::string valence_differs(const Mesh& mesh, const Sides& sides, const Values& values) {
  demand_size(values, 2);
  demand(values[0] >= 0 && static_cast<std::size_t>(values[0]) < mesh.vertices,
         "degenerate: a vertex that is none");
  const auto vertex = static_cast<std::size_t>(values[0]);
  const std::size_t edges = valences(mesh, sides)[vertex];
  if (std::cmp_equal(edges, values[1])) return {};
  return numbered("vertex", vertex) + " has valence " + std::to_string(edges);
}

std::string not_all_planar(Context& context, const Mesh& mesh, const Values& faces) {
  if (faces.empty())
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
      if (std::string no = not_planar(context, mesh, f); !no.empty()) return no;
  for (const int f : faces) {
    demand(f >= 0 && static_cast<std::size_t>(f) < mesh.faces.size(),
           "degenerate: a face that is none");
    if (std::string no = not_planar(context, mesh, static_cast<std::size_t>(f)); !no.empty())
      return no;
  }
  return {};
}

std::string differs(Context& context, const certificate::Mesh& stated) {
  const Mesh mesh = make_mesh(context, stated);
  const Sides sides(mesh, context.meter());
  Multiset numbers;
  switch (stated.property) {
    case Property::counts:
      return counts_differ(mesh, sides, stated.values);
    case Property::face_sizes:
      for (const auto& face : mesh.faces) ++numbers.count[face.size()];
      return numbers.is(stated.values) ? "" : numbers.text("faces: ", "", " sides");
    case Property::valences:
      for (const std::size_t edges : valences(mesh, sides)) ++numbers.count[edges];
      return numbers.is(stated.values) ? "" : numbers.text("vertices: ", "valence ", "");
    case Property::valence:
      return valence_differs(mesh, sides, stated.values);
    case Property::planar:
      return not_all_planar(context, mesh, stated.values);
    default:
      demand_size(stated.values, 0);
  }
  switch (stated.property) {
    case Property::connected:
      return not_connected(mesh, sides, context.meter());
    case Property::closed: {
      const std::string edge = not_two_faces(sides);
      return edge.empty() ? not_connected(mesh, sides, context.meter()) : edge;
    }
    case Property::manifold:
      return not_manifold(mesh, sides, context.meter());
    case Property::orientable:
      return not_orientable(mesh, sides, context.meter());
    case Property::oriented:
      return not_oriented(sides);
    case Property::convex:
      return not_convex(context, mesh);
    default:
      throw Open("malformed: an unknown property of a mesh");
  }
}

}  // namespace

bool decide(Context& context, const certificate::Mesh& mesh, const certificate::Proof& proof) {
  demand(std::holds_alternative<certificate::Computation>(proof),
         "evidence of a kind that says nothing of a mesh");
  context.failed_at = differs(context, mesh);
  return context.failed_at.empty();
}

}  // namespace seam::check
