// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "geometry/surface.h"
#include "symbolic/proposition.h"

namespace seam::geometry {

using symbolic::Proposition;

/// An exact similarity x -> scale * M x + shift that carries one surface onto the other (as
/// sets of patches), if one is found.
struct Similarity {
  Formula scale;
  Matrix matrix;  ///< orthogonal
  Point shift;
};
std::optional<Similarity> find_similarity(const Surface&, const Surface&, Numbers&);

/// The similarity found is stated: M orthogonal, scale > 0, every patch carried to one. If none
/// is found: that a quantity agrees which does not. In space.
Proposition similar(const Surface&, const Surface&, Numbers&);
Proposition congruent(const Surface&, const Surface&, Numbers&);

}  // namespace seam::geometry
