// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "check/mesh.h"
#include "check/partition.h"

// A corner of a face is called by the side that leaves it. Where each edge has two sides, each
// corner has two neighbours round its vertex, across the side that leaves and across the one
// that comes; so the corners at a vertex form cycles, and there is one cycle a vertex just if
// there are as many cycles as vertices and each vertex has one.

namespace seam::check {

std::string not_two_faces(const Sides& sides) {
  for (std::size_t s = 0; s < sides.count(); ++s)
    if (sides.mate[s] == Sides::none)
      return "the edge from " + numbered("vertex", sides.start[s]) + " to " +
             numbered("vertex", sides.end[s]) + " is not on two faces";
  return {};
}

std::string not_connected(const Mesh& mesh, const Sides& sides, Meter& meter) {
  Partition parts(mesh.vertices);
  for (std::size_t s = 0; s < sides.count(); ++s) {
    meter.charge(1);
    parts.merge(sides.start[s], sides.end[s]);
  }
  for (std::size_t v = 1; v < mesh.vertices; ++v)
    if (!parts.are_together(0, v))
      return "no edges lead from vertex 1 to " + numbered("vertex", v);
  return {};
}

std::string not_manifold(const Mesh& mesh, const Sides& sides, Meter& meter) {
  if (std::string edge = not_two_faces(sides); !edge.empty()) return edge;
  Partition cycles(sides.count());
  for (std::size_t s = 0; s < sides.count(); ++s) {
    meter.charge(2);
    const std::size_t t = sides.mate[s];
    const bool alike = sides.run_alike(s, t);
    cycles.merge(s, alike ? t : sides.next[t]);
    cycles.merge(sides.next[s], alike ? sides.next[t] : t);
  }
  std::vector<std::size_t> corner(mesh.vertices, Sides::none);
  for (std::size_t s = 0; s < sides.count(); ++s) {
    std::size_t& first = corner[sides.start[s]];
    if (first == Sides::none) first = s;
    if (!cycles.are_together(first, s))
      return "the faces round " + numbered("vertex", sides.start[s]) + " are not one cycle";
  }
  for (std::size_t v = 0; v < mesh.vertices; ++v)
    if (corner[v] == Sides::none) return numbered("vertex", v) + " is on no face";
  return {};
}

std::string not_oriented(const Sides& sides) {
  if (std::string edge = not_two_faces(sides); !edge.empty()) return edge;
  for (std::size_t s = 0; s < sides.count(); ++s)
    if (sides.run_alike(s, sides.mate[s]))
      return numbered("face", sides.face[s]) + " and " +
             numbered("face", sides.face[sides.mate[s]]) +
             " pass the edge between them in the same sense";
  return {};
}

// Each face comes as it is and turned over. Neighbours that agree are joined. A face that is
// joined with itself turned over cannot be either.
std::string not_orientable(const Mesh& mesh, const Sides& sides, Meter& meter) {
  if (sides.most_of_an_edge > 2) return "an edge is on more than two faces";
  const std::size_t turned = mesh.faces.size();
  Partition agreeing(2 * turned);
  for (std::size_t s = 0; s < sides.count(); ++s) {
    meter.charge(2);
    const std::size_t t = sides.mate[s];
    if (t == Sides::none) continue;
    const std::size_t f = sides.face[s], g = sides.face[t];
    const bool alike = sides.run_alike(s, t);
    agreeing.merge(f, alike ? g + turned : g);
    agreeing.merge(f + turned, alike ? g : g + turned);
  }
  for (std::size_t f = 0; f < turned; ++f)
    if (agreeing.are_together(f, f + turned))
      return "a walk over neighbours from " + numbered("face", f) +
             " comes back to it turned over";
  return {};
}

}  // namespace seam::check
