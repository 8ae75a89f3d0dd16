// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include <string>
#include <vector>

#include "check/context.h"
#include "check/region.h"

namespace seam::check {

/// Faces by the numbers of their corners. The points, if there are any, are all multiplied by
/// one number > 0.
struct Mesh {
  std::size_t vertices = 0;
  std::vector<Coordinates> points;
  std::vector<std::vector<std::size_t>> faces;
  std::size_t first_cut = ~std::size_t{0};  ///< from this face on they cut off a vertex
};

/// The sides of all faces, numbered face by face, from each corner to the next.
struct Sides {
  static constexpr std::size_t none = ~std::size_t{0};

  explicit Sides(const Mesh&, Meter&);

  std::vector<std::size_t> start, end, face, next, previous;
  std::vector<std::size_t> mate;  ///< the other side of the same edge, if it has just two
  std::size_t edges = 0;
  std::size_t most_of_an_edge = 0;  ///< sides

  std::size_t count() const { return start.size(); }
  bool run_alike(std::size_t s, std::size_t t) const { return start[s] == start[t]; }
};

// In words where the mesh has not the property; of one that has it, nothing. For what each
// says see `certificate::Mesh`.
std::string not_two_faces(const Sides&);
std::string not_connected(const Mesh&, const Sides&, Meter&);
std::string not_manifold(const Mesh&, const Sides&, Meter&);
std::string not_oriented(const Sides&);
std::string not_orientable(const Mesh&, const Sides&, Meter&);
std::string not_planar(Context&, const Mesh&, std::size_t face);
std::string not_convex(Context&, const Mesh&);

/// How many edges each vertex has.
std::vector<std::size_t> valences(const Mesh&, const Sides&);

/// The mesh of the statement, truncated as it says. Throws `Open` where that is not possible.
Mesh make_mesh(Context&, const certificate::Mesh&);

Coordinates difference(Ring&, const Coordinates& a, const Coordinates& b);
Coordinates cross(Ring&, const Coordinates& a, const Coordinates& b);
Polynomial dot(Ring&, const Coordinates& a, const Coordinates& b);

/// `vertex 3`, counted from 1 as in the language.
std::string numbered(const char* what, std::size_t index);

}  // namespace seam::check
