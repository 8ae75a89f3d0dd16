// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/side_contact.h"

// Let p and q have their common side at v = 0, both patches at v > 0. Along it, as polynomials
// in u: T = p_u, A = p_v, B = q_v.
//
// G1.  (0) p(u,0) = q(u,0) identically, so T = q_u too.
//      (1) det(T, A, B) = 0 identically.
//      (2) (T x A).(T x B) < 0 for all u in [0,1].
//
//   By (2) T x A and T x B are never 0: both patches are regular along the side, ends included,
//   and T is never 0. Both normals are orthogonal to T, and by (1) B lies in the plane of T and
//   A, so they are parallel: the tangent planes are equal. In that plane, which T cuts in two
//   halves, (2) says that A and B point into different ones; p and q leave towards A and B (a
//   patch lies at v > 0), so they leave on opposite sides. Conversely, equal tangent planes
//   give (1); regular patches leaving on opposite sides give (2). A fold has both on one side,
//   a cusp a normal 0.
//
// G2.  With N = T x A, D = N.N, a = (B x A).N, b = (T x B).N: in B = x T + y A cross with A and
// with T
//      to get B x A = x N and T x B = y N, so D B = a T + b A. The second fundamental form of p
//      with respect to the normal N/|N| has, times |N|, the values N.p_uu on (T,T), N.p_uv on
//      (T,A), N.p_vv on (A,A); that of q, with respect to the same normal, N.q_uu on (T,T),
//      N.q_uv on (T,B), N.q_vv on (B,B), and q_uu = p_uu by (0). (T,B) is a basis of the plane,
//      so the forms are equal exactly if they are on (T,B) and (B,B):
//
//      (3) D (N.q_uv)   = a (N.p_uu) + b (N.p_uv)
//      (4) D^2 (N.q_vv) = a^2 (N.p_uu) + 2 a b (N.p_uv) + b^2 (N.p_vv)
//
//   identically: polynomials that agree on [0,1] agree.

namespace seam::geometry {
namespace {

using symbolic::all;
using symbolic::any;
using symbolic::atom;
using symbolic::product;
using symbolic::Relation;
using symbolic::Sign;
using symbolic::Zero;

Proposition vanishes(const Formula& f, std::string about) {
  return atom(Zero{f}, std::move(about));
}

Proposition tangent_planes(const Contact& c) {
  const Point t = along_side(c.p, 1, 0), a = along_side(c.p, 0, 1), b = along_side(c.q, 0, 1);
  const symbolic::Domain side{{symbolic::interval(parameter_u, 0, 1)}, {}};
  return all({vanishes(determinant({t, a, b}), "equal tangent planes"),
              atom(Sign{dot(cross(t, a), cross(t, b)), Relation::negative, side},
                   "regular, and the patches leave on opposite sides")});
}

Proposition second_forms(const Contact& c) {
  const Point t = along_side(c.p, 1, 0), a = along_side(c.p, 0, 1), b = along_side(c.q, 0, 1);
  const Point n = cross(t, a);
  const Formula d = norm2(n), of_t = dot(cross(b, a), n), of_a = dot(cross(t, b), n);
  const Formula uu = dot(n, along_side(c.p, 2, 0)), uv = dot(n, along_side(c.p, 1, 1)),
                vv = dot(n, along_side(c.p, 0, 2));
  const Formula mixed = of_t * uu + of_a * uv;
  const Formula across =
      product({of_t, of_t, uu}) + product({2, of_t, of_a, uv}) + product({of_a, of_a, vv});
  return all({vanishes(d * dot(n, along_side(c.q, 1, 1)) - mixed,
                       "equal second fundamental forms, along and across"),
              vanishes(d * d * dot(n, along_side(c.q, 0, 2)) - across,
                       "equal second fundamental forms, across")});
}

Point difference(const Contact& c) {
  return along_side(c.p, 0, 0) - along_side(c.q, 0, 0);
}

}  // namespace

Point along_side(const Patch& p, int i, int j) {
  return evaluate(edge(derivative(p, i, j), 1), Formula::symbol(parameter_u));
}

Contact contact(const std::vector<Patch>& patches, const Seam& seam) {
  return {along(patches.at(seam.patch), seam.side, false),
          along(patches.at(seam.other_patch), seam.other_side, seam.reversed)};
}

Proposition g0(const Contact& c) {
  std::vector<Proposition> parts;
  for (const Formula& coordinate : difference(c))
    parts.push_back(vanishes(coordinate, "equal boundary curves"));
  return all(std::move(parts));
}

Proposition g1(const Contact& c) {
  return all({g0(c), tangent_planes(c)});
}

Proposition g2(const Contact& c) {
  return all({g1(c), second_forms(c)});
}

std::vector<SideIndex> all_sides(const std::vector<Patch>& patches) {
  std::vector<SideIndex> result;
  for (int patch = 0; patch < std::ssize(patches); ++patch)
    for (int side = 1; side <= patches[patch].sides(); ++side) result.push_back({patch, side});
  return result;
}

// A sum of squares is identically 0 only if every coordinate is: one statement a pair.
Proposition some_side_agrees(const std::vector<Patch>& patches,
                             const std::vector<SideIndex>& these,
                             const std::vector<SideIndex>& those) {
  std::vector<Proposition> alternatives;
  for (const SideIndex& a : these)
    for (const SideIndex& b : those)
      for (const bool reversed : {false, true}) {
        if (a.patch == b.patch && a.side == b.side) continue;
        const Contact c = contact(patches, {a.patch, a.side, b.patch, b.side, reversed});
        alternatives.push_back(vanishes(
            norm2(difference(c)), name(a) + " is " + name(b) + (reversed ? ", reversed" : "")));
      }
  return any(std::move(alternatives));
}

std::string name(const SideIndex& side) {
  return "side " + std::to_string(side.side) + " of patch " + std::to_string(side.patch + 1);
}

}  // namespace seam::geometry
