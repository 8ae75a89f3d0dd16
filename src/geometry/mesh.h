// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/vector.h"
#include "symbolic/numbers.h"

namespace seam::geometry {

using symbolic::Numbers;

/// Faces by the indices of their vertices, in order round the face, seen from outside
/// counterclockwise.
struct Mesh {
  std::vector<Point> vertices;
  std::vector<std::vector<int>> faces;
};

using Face = std::vector<Point>;
using MeshEdge = std::vector<Point>;  ///< two points

std::vector<Face> faces(const Mesh&);
std::vector<MeshEdge> edges(const Mesh&);  ///< each once, by rising vertex indices
int valence(const Mesh&, const Point& vertex,
            const Numbers&);                          ///< the edges that end in this point
Point centroid(const std::vector<Point>&, Numbers&);  ///< the mean of the points; not of none

/// Vertices at the centroids of the faces, in their order; a face for each vertex whose faces
/// close up round it, in the order of the vertices.
Mesh dual(const Mesh&, Numbers&);
Mesh scale(const Formula& k, const Mesh&);

}  // namespace seam::geometry
