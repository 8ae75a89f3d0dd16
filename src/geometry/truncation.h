// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "geometry/mesh.h"

namespace seam::geometry {

/// Why it is no oriented manifold (each edge is passed once in each sense, the faces round each
/// vertex form one cycle, and there are some); empty if it is one. Vertices count from 1.
std::string not_oriented_manifold(const Mesh&);

/// Each edge ab cut at a + r (b - a) and b + r (a - b): a 2n-gon for each n-gon, then for each
/// vertex the polygon of the cuts near it. Numbered as `certificate::Mesh` says. The mesh
/// is an oriented manifold, and so is the result.
Mesh truncate(const Mesh&, const Formula& ratio);

/// Why truncation keeps planar what is planar and 3-valent: a cut lies in each plane in which
/// its edge lies, and the three cuts near a vertex lie in one plane.
symbolic::Proposition planarity_step(const Formula& ratio);

}  // namespace seam::geometry
