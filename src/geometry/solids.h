// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/mesh.h"

namespace seam::geometry {

/// The Platonic solids with the vertices of the language contract, each aligned with its dual.
Mesh tetrahedron(Numbers&);
Mesh cube(Numbers&);
Mesh octahedron(Numbers&);
Mesh dodecahedron(Numbers&);
Mesh icosahedron(Numbers&);

}  // namespace seam::geometry
