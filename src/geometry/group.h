// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/matrix.h"
#include "geometry/mesh.h"

namespace seam::geometry {

/// The finite group of rotations (or of all symmetries) of a solid whose centroid is the
/// origin, as exact 3 x 3 matrices that permute its vertices; the identity first, the rest in a
/// fixed order. NumberError if all vertices lie on one line through the origin: then there are
/// infinitely many.
std::vector<Matrix> rotations(const Mesh&, Numbers&);
std::vector<Matrix> symmetries(const Mesh&, Numbers&);

}  // namespace seam::geometry
