// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/patch.h"

// Curvatures of a patch in space as quotients of polynomials in its parameters, with n = D1 x
// D2.
namespace seam::geometry {

struct Quotient {
  Formula numerator, denominator;
};

/// Gauss curvature: K = ((n.p_uu)(n.p_vv) - (n.p_uv)^2) / (n.n)^2.
Quotient gauss(const Patch&, const Formula& u, const Formula& v);
/// The same from the normal and the second derivatives.
Quotient gauss(const Point& n, const Point& uu, const Point& uv, const Point& vv);

/// Mean curvature times |n|, for H itself holds the root |n|: H |n| = h / (2 (n.n)), with
/// h = (D2.D2)(n.p_uu) - 2 (D1.D2)(n.p_uv) + (D1.D1)(n.p_vv).
Quotient mean_times_norm(const Patch&, const Formula& u, const Formula& v);

}  // namespace seam::geometry
