// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

Proposition g0(const Contact&);
Proposition g1(const Contact&);  ///< G0 included
Proposition g2(const Contact&);  ///< G1 included

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
