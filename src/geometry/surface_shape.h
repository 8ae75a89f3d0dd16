// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/chart.h"
#include "geometry/contact.h"

// The shape of a surface, and of a curve on it. Each says exactly what the table "Predicates"
// of docs/language.md says.
namespace seam::geometry {

/// The normal vanishes nowhere on the domain.
Proposition regular(const Chart&);

/// The Gauss curvature is 0 wherever there is one, and the normal is not identically 0.
Criterion developable(const Chart&, const Search&);

/// Linear in one parameter.
Criterion ruled(const Chart&, const Search&);

/// Linear in one parameter, all rulings parallel.
Criterion cylindrical(const Chart&, const Search&);

/// Where one parameter (the second, if not `first`) has this value, the surface is the curve;
/// x' and x'' are independent there, the normal is not 0, and it lies in the plane of the two.
Criterion pregeodesic(const Arc& x, const Chart& y, bool first, const Formula& value);

}  // namespace seam::geometry
