// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "geometry/surface.h"
#include "symbolic/proposition.h"

// What it means for two patches to meet along one side of each.
namespace seam::geometry {

using symbolic::Proposition;

/// Two patches with the sides in question at v = 0, run through in the direction in which they
/// are to be one curve.
struct Contact {
  Patch p, q;
};
Contact contact(const std::vector<Patch>&, const Seam&);

using Condition = std::function<Proposition(const Contact&)>;

Proposition g0(const Contact&);
Proposition g1(const Contact&);  ///< G0 included
Proposition g2(const Contact&);  ///< G1 included

/// G(k): with some reparametrisation q continues p across the side so that all derivatives to
/// this order are equal there, both regular, on opposite sides. From order 1 on it includes G1;
/// of order 0, 1, 2 it says what G0, G1, G2 say.
Proposition equal_jets(const Contact&, int order);

/// C(k): q continues p across the side as they are parametrised, over two squares, or two
/// triangles that make a parallelogram: all derivatives to this order are equal there. Requires
/// patches of one shape.
Proposition equal_derivatives(const Contact&, int order);

/// d^(i+j) p / du^i dv^j along the side v = 0, in the symbol parameter_u.
Point along_side(const Patch&, int i, int j);

struct SideIndex {
  int patch, side;
};
std::vector<SideIndex> all_sides(const std::vector<Patch>&);

/// One of these sides is one of those, in one direction or the other: every pair is an
/// alternative. A side is not compared with itself.
Proposition some_side_agrees(const std::vector<Patch>&, const std::vector<SideIndex>& these,
                             const std::vector<SideIndex>& those);

std::string name(const SideIndex&);  ///< `side 2 of patch 5`, counted from 1

}  // namespace seam::geometry
