// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curvature.h"
#include "geometry/gluing.h"

// Why a closed G1 surface of polynomial patches with K > 0 bounds a convex body.
//
//   A compact connected surface, mapped to space one to one near each of its points, that is
//   near each of them part of the boundary of a convex body, and at one of them strictly so,
//   bounds a convex body and has no double points (J. van Heijenoort, On locally convex
//   manifolds, Comm. Pure Appl. Math. 5, 1952; for smooth surfaces Hadamard's theorem, do
//   Carmo, Differential Geometry of Curves and Surfaces, 5.6 B). No derivative is asked for, so
//   patches may meet in G1 only. Near by:
//
//   Inside a patch K > 0 makes it so, strictly.
//
//   On a seam, G1 makes the surface near a point a graph z = f(x,y) over the tangent plane, f
//   with continuous gradient, smooth on each side of the curve of the seam up to that curve.
//   With N one common normal and T the tangent of the seam, N.T_u is the value on (T,T) of
//   either patch's second fundamental form, for T_u is the same for both. K > 0 makes both
//   forms definite, so N.T_u is not 0 and both have its sign: the patches bend to the same
//   side, and f (or -f) has a positive definite second derivative on both sides. On a line that
//   meets the projected seam in finitely many points, f is then convex: its derivative is
//   continuous and rises piecewise. The seam is an arc of an algebraic curve, so almost every
//   parallel of a line is such a line, and by continuity f is convex on every line.
//
//   At a corner, G1 along the seams and winding once make the surface a graph too (see
//   winding), and the sign is handed on from seam to seam; the rest is the same with several
//   curves.
//
// Conversely these conditions are what `convex` means in the language. The Euler characteristic
// of the boundary of a convex body is 2. Where the numerator of K is > 0 the normal is not 0
// (else it were 0), and the denominator (n.n)^2 is > 0: the numerator alone is stated.

namespace seam::geometry {

Proposition convex(const Surface& s, const Numbers& numbers) {
  std::vector<Proposition> parts{closed(s, 2, numbers), g1(s, numbers)};
  const Formula u = Formula::symbol(parameter_u), v = Formula::symbol(parameter_v);
  for (std::size_t k = 0; k < s.patches.size(); ++k)
    parts.push_back(
        atom(symbolic::Sign{gauss(s.patches[k], u, v).numerator, symbolic::Relation::positive,
                            domain(s.patches[k], parameter_u, parameter_v)},
             "Gauss curvature > 0 on patch " + std::to_string(k + 1)));
  return all(std::move(parts));
}

}  // namespace seam::geometry
