// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/truncation.h"

#include <map>

#include "exact/contract.h"
#include "geometry/contact.h"

// The cut near the first end of side i is new vertex i. A new 2n-gon passes the cuts of each of
// its sides, that of the side itself, then that of its mate, the side of the neighbour along
// the same edge. Round a vertex: from the cut of the side j that leaves it to that of the mate
// of the side before j, which leaves it too.
//
// So a mesh of V vertices, E edges and F faces becomes one of 2E, 3E and V + F: a vertex for
// each end of an edge; for each edge its middle part, and for each corner of a face, of which
// there are 2E, an edge that cuts it off; a face for each face and for each vertex. Each new
// vertex is on one middle part and on two of the others: all are 3-valent.
//
// Where all faces are planar and all vertices 3-valent, this is so after a truncation: the cuts
// of a face lie on its sides, so in its plane; near a vertex there are three. By induction it
// is so for ever.

namespace seam::geometry {
namespace {

constexpr int none = -1;

struct Sides {
  std::vector<int> start, end, previous, mate;
  std::string fault;

  explicit Sides(const Mesh& mesh) {
    for (const auto& face : mesh.faces) {
      const int first = static_cast<int>(start.size()), n = static_cast<int>(face.size());
      for (int k = 0; k < n; ++k) {
        start.push_back(face[k]);
        end.push_back(face[(k + 1) % n]);
        previous.push_back(first + (k + n - 1) % n);
      }
    }
    std::map<std::pair<int, int>, int> by_ends;
    const auto edge = [&](std::size_t s) {
      return "the edge from vertex " + std::to_string(start[s] + 1) + " to vertex " +
             std::to_string(end[s] + 1);
    };
    for (std::size_t s = 0; s < start.size(); ++s)
      if (!by_ends.emplace(std::pair(start[s], end[s]), static_cast<int>(s)).second)
        fault = "two faces pass " + edge(s) + " in the same sense";
    mate.assign(start.size(), none);
    for (std::size_t s = 0; s < start.size() && fault.empty(); ++s) {
      const auto found = by_ends.find({end[s], start[s]});
      if (found == by_ends.end())
        fault = edge(s) + " is on one face only";
      else
        mate[s] = found->second;
    }
  }
};

// For each vertex the sides that leave it, going round.
std::vector<std::vector<int>> rounds(const Mesh& mesh, const Sides& sides) {
  std::vector<std::vector<int>> result(mesh.vertices.size());
  for (int first = 0; first < std::ssize(sides.start); ++first) {
    auto& round = result[sides.start[first]];
    if (!round.empty()) continue;
    int side = first;
    do {
      round.push_back(side);
      side = sides.mate[sides.previous[side]];
    } while (side != first);
  }
  return result;
}

}  // namespace

std::string not_oriented_manifold(const Mesh& mesh) {
  const Sides sides(mesh);
  if (!sides.fault.empty()) return sides.fault;
  std::vector<std::size_t> leaving(mesh.vertices.size());
  for (const int vertex : sides.start) ++leaving[vertex];
  const auto all = rounds(mesh, sides);
  for (std::size_t v = 0; v < all.size(); ++v) {
    const std::string vertex = "vertex " + std::to_string(v + 1);
    if (all[v].empty()) return vertex + " is on no face";
    if (all[v].size() < leaving[v]) return "the faces round " + vertex + " are not one cycle";
  }
  return {};
}

Mesh truncate(const Mesh& mesh, const Formula& ratio) {
  const Sides sides(mesh);
  exact::require(sides.fault.empty(), "truncate: no oriented manifold");
  Mesh result;
  for (std::size_t s = 0; s < sides.start.size(); ++s) {
    const Point &a = mesh.vertices[sides.start[s]], &b = mesh.vertices[sides.end[s]];
    result.vertices.push_back(a + ratio * (b - a));
  }
  int side = 0;
  for (const auto& face : mesh.faces) {
    auto& cut = result.faces.emplace_back();
    for (std::size_t k = 0; k < face.size(); ++k, ++side) {
      cut.push_back(side);
      cut.push_back(sides.mate[side]);
    }
  }
  for (auto& round : rounds(mesh, sides)) result.faces.push_back(std::move(round));
  result.base = mesh.base ? mesh.base : std::make_shared<const Mesh>(mesh);
  result.ratios = mesh.ratios;
  result.ratios.push_back(ratio);
  return result;
}

// n.((1 - r) P + r Q) - d is a combination of n.P - d and n.Q - d, and 0 where these are.
symbolic::Proposition planarity_step(const Formula& ratio) {
  const auto point = [](const std::string& name) {
    Point result;
    for (const char* place : {"~[1]", "~[2]", "~[3]"})
      result.push_back(Formula::symbol(name + place));
    return result;
  };
  const Point n = point("n"), p = point("P");
  const Formula d = Formula::symbol("d~");
  const auto cut = [&](const Point& q) { return p + ratio * (q - p); };
  const Point q = point("Q");
  const Formula in_plane = dot(n, cut(q)) - d;
  const Formula combination = (1 - ratio) * (dot(n, p) - d) + ratio * (dot(n, q) - d);
  return symbolic::all({symbolic::atom(symbolic::Zero{in_plane - combination},
                                       "step: a cut lies in each plane of its edge"),
                        symbolic::all({planar({cut(q), cut(point("R")), cut(point("S"))})},
                                      "step: the cuts near a 3-valent vertex")});
}

}  // namespace seam::geometry
