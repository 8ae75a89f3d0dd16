// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "exact/contract.h"
#include "geometry/nearness.h"

namespace seam::geometry {
namespace {

using IndexPair = std::pair<int, int>;

std::set<IndexPair> edge_indices(const Mesh& mesh) {
  std::set<IndexPair> result;
  for (const auto& face : mesh.faces)
    for (std::size_t k = 0; k < face.size(); ++k)
      result.insert(std::minmax(face[k], face[(k + 1) % face.size()]));
  return result;
}

std::vector<int> multiset(const std::map<int, int>& count) {
  std::vector<int> result;
  for (const auto& [number, times] : count) {
    result.push_back(number);
    result.push_back(times);
  }
  return result;
}

// Round a vertex, counterclockwise: the face left of the side that leaves for x comes to the
// vertex from some y; the next face is the one left of the side that leaves for y. Every face
// is passed once, or the walk breaks off.
struct Leaving {
  int face, came_from;
};

std::vector<int> faces_round(const std::map<int, Leaving>& by_target) {
  std::vector<int> result;
  if (by_target.empty()) return result;
  const int start = by_target.begin()->first;
  int target = start;
  do {
    const auto leaving = by_target.find(target);
    if (leaving == by_target.end() || result.size() == by_target.size()) return {};
    result.push_back(leaving->second.face);
    target = leaving->second.came_from;
  } while (target != start);
  if (result.size() != by_target.size()) return {};
  std::ranges::rotate(result, std::ranges::min_element(result));
  return result;
}

}  // namespace

std::vector<Face> faces(const Mesh& mesh) {
  std::vector<Face> result;
  for (const auto& face : mesh.faces) {
    result.emplace_back();
    for (const int vertex : face) result.back().push_back(mesh.vertices.at(vertex));
  }
  return result;
}

std::vector<MeshEdge> edges(const Mesh& mesh) {
  std::vector<MeshEdge> result;
  for (const auto& [a, b] : edge_indices(mesh))
    result.push_back({mesh.vertices.at(a), mesh.vertices.at(b)});
  return result;
}

std::optional<int> find_vertex(const Mesh& mesh, const Point& vertex, const Numbers& numbers) {
  const auto same = [](const Formula& a, const Formula& b) { return a.same(b); };
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    if (std::ranges::equal(mesh.vertices[i], vertex, same)) return static_cast<int>(i);
  return PointIndex(mesh.vertices, numbers).find(vertex);
}

int valence(const Mesh& mesh, int vertex) {
  return static_cast<int>(std::ranges::count_if(edge_indices(mesh), [&](const IndexPair& edge) {
    return edge.first == vertex || edge.second == vertex;
  }));
}

symbolic::Proposition has(const Mesh& mesh, Property property, std::vector<int> values,
                          std::string about) {
  const Mesh& base = mesh.base ? *mesh.base : mesh;
  symbolic::Mesh stated{static_cast<int>(base.vertices.size()),
                        {},
                        base.faces,
                        mesh.ratios,
                        property,
                        std::move(values)};
  if (property == Property::planar || property == Property::convex)
    stated.points = base.vertices;
  return symbolic::atom(std::move(stated), std::move(about));
}

std::vector<int> counts(const Mesh& mesh) {
  return {static_cast<int>(mesh.vertices.size()), static_cast<int>(edge_indices(mesh).size()),
          static_cast<int>(mesh.faces.size())};
}

std::vector<int> face_sizes(const Mesh& mesh) {
  std::map<int, int> count;
  for (const auto& face : mesh.faces) ++count[static_cast<int>(face.size())];
  return multiset(count);
}

std::vector<int> valences(const Mesh& mesh) {
  std::vector<int> edges(mesh.vertices.size(), 0);
  for (const auto& [a, b] : edge_indices(mesh)) {
    ++edges.at(a);
    ++edges.at(b);
  }
  std::map<int, int> count;
  for (const int n : edges) ++count[n];
  return multiset(count);
}

bool is_trivalent(const Mesh& mesh) {
  return valences(mesh) == std::vector{3, static_cast<int>(mesh.vertices.size())};
}

Point centroid(const std::vector<Point>& points, Numbers& numbers) {
  exact::require(!points.empty(), "centroid of no points");
  Point total = points[0];
  for (std::size_t i = 1; i < points.size(); ++i) total = total + points[i];
  const exact::Rational share(1, points.size());
  return normal_form(Formula(share) * total, numbers);
}

Mesh dual(const Mesh& mesh, Numbers& numbers) {
  Mesh result;
  for (const Face& face : faces(mesh)) result.vertices.push_back(centroid(face, numbers));

  std::vector<std::map<int, Leaving>> leaving(mesh.vertices.size());
  for (int f = 0; f < std::ssize(mesh.faces); ++f) {
    const auto& face = mesh.faces[f];
    for (std::size_t k = 0; k < face.size(); ++k)
      leaving.at(face[k]).insert(
          {face[(k + 1) % face.size()], {f, face[(k + face.size() - 1) % face.size()]}});
  }
  for (const auto& round : leaving)
    if (auto face = faces_round(round); !face.empty()) result.faces.push_back(std::move(face));
  return result;
}

Mesh scale(const Formula& k, const Mesh& mesh) {
  Mesh result{mesh.vertices, mesh.faces};
  for (Point& vertex : result.vertices) vertex = k * vertex;
  return result;
}

}  // namespace seam::geometry
