// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/vector.h"
#include "symbolic/numbers.h"
#include "symbolic/proposition.h"

namespace seam::geometry {

using symbolic::Numbers;

/// Faces by the indices of their vertices, in order round the face, seen from outside
/// counterclockwise.
struct Mesh {
  std::vector<Point> vertices;
  std::vector<std::vector<int>> faces;

  /// Of a mesh that came of truncation: what was truncated, and at which ratios, in order.
  std::shared_ptr<const Mesh> base = nullptr;
  std::vector<Formula> ratios = {};
};

using Face = std::vector<Point>;
using MeshEdge = std::vector<Point>;  ///< two points

std::vector<Face> faces(const Mesh&);
std::vector<MeshEdge> edges(const Mesh&);  ///< each once, by rising vertex indices
std::optional<int> find_vertex(const Mesh&, const Point&, const Numbers&);
int valence(const Mesh&, int vertex);                 ///< the edges that end in it
Point centroid(const std::vector<Point>&, Numbers&);  ///< the mean of the points; not of none

using Property = symbolic::Mesh::Property;
/// That the mesh has the property, stated of what it was truncated from.
symbolic::Proposition has(const Mesh&, Property, std::vector<int> values = {},
                          std::string about = {});

/// Vertices, edges, faces.
std::vector<int> counts(const Mesh&);
/// The number of corners of faces; of edges at vertices: each, and how often, by rising number.
std::vector<int> face_sizes(const Mesh&);
std::vector<int> valences(const Mesh&);
bool is_trivalent(const Mesh&);  ///< three edges at each vertex

/// Vertices at the centroids of the faces, in their order; a face for each vertex whose faces
/// close up round it, in the order of the vertices.
Mesh dual(const Mesh&, Numbers&);
Mesh scale(const Formula& k, const Mesh&);

}  // namespace seam::geometry
