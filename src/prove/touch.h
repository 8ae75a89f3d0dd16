// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "prove/subdivide.h"

namespace seam::prove {

/// A place near the piece where f, found small there, is 0 or negative, exactly; or where a
/// minimum of f is so little above 0 that the search had better cut there.
struct Touch {
  Place place;       ///< of sum 1 in each factor
  exact::Sign sign;  ///< of f there
};

/// Looks for minima of f on the faces of the domain, from each piece on: the location in
/// doubles, then an exact guess: small fractions, numbers over the tower, roots of polynomials
/// with small integers, on an edge a double root of f along it; the workshop's tower may grow.
/// `f` is in barycentric coordinates.
std::vector<Touch> find_touches(Workshop&, const Factors&, const Barycentric& f,
                                const std::vector<const Piece*>& pieces);

}  // namespace seam::prove
