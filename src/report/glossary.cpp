// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/glossary.h"

#include <algorithm>

namespace seam::report {
namespace {

const std::vector<GlossaryEntry> entries = {
    {"regular",
     "The normal $D_1 \\times D_2$ of the patch vanishes nowhere on the closed domain."},
    {"G0",
     "One full edge of the first patch is one full edge of the second: the same points, with "
     "the "
     "same parametrisation up to reversal. Of a surface: so at every seam."},
    {"G1",
     "$G^0$; both patches are regular along the edge; their tangent planes are equal at every "
     "point of it, the ends included; and the patches leave it on opposite sides (no fold). Of "
     "a "
     "surface: so at every seam, and at every interior corner the patches wind round the "
     "normal "
     "exactly once."},
    {"G2",
     "$G^1$, and equal second fundamental forms at every point of the edge. Of a surface: so "
     "at "
     "every seam."},
    {"G",
     "$G(k,p,q)$: $G^1$ (for $k = 0$: $G^0$), and with some reparametrisation of the second "
     "patch "
     "all derivatives to order $k$ are equal along the common edge. Of two curves: so where "
     "the "
     "first ends and the second begins, both regular there."},
    {"C",
     "$C(k,p,q)$: one full edge of the first patch is one full edge of the second, and all "
     "derivatives to order $k$ are equal along it, with the domains side by side: two squares, "
     "or "
     "two triangles that make a parallelogram. Of two curves: where the first ends and the "
     "second "
     "begins."},
    {"closed",
     "Every edge of every patch lies on exactly one seam, and the surface is connected. Of a "
     "mesh: edges lead from each vertex to each other, and each edge is on exactly two faces."},
    {"connected", "Edges lead from each vertex of the mesh to each other."},
    {"manifold",
     "Each edge of the mesh is on exactly two faces, and the faces round each vertex form one "
     "cycle."},
    {"orientable",
     "The faces of the mesh can be turned so that the two at each edge pass it in opposite "
     "senses."},
    {"oriented", "The two faces at each edge of the mesh pass it in opposite senses."},
    {"trivalent", "Three edges end in each vertex of the mesh."},
    {"convex",
     "The surface is closed and $G^1$, and its Gauss curvature is positive everywhere: it "
     "bounds "
     "a convex body. Of a mesh: it is the boundary of a convex polyhedron that has its "
     "vertices "
     "and its faces."},
    {"interpolates",
     "Every one of the points is a corner of a patch or the image of an exact parameter."},
    {"similar", "An exact similarity carries one onto the other."},
    {"congruent", "An exact isometry carries one onto the other."},
    {"pregeodesic",
     "On the patch $y(s,t)$ the curve $s = 0$ is $x(t)$; $x' \\times x''$ vanishes nowhere "
     "there, "
     "$y$ is regular along it, and the product of the normal with $x' \\times x''$ is "
     "identically "
     "zero."},
    {"developable", "The Gauss curvature is identically zero."},
    {"ruled", "The patch is linear in one of its parameters."},
    {"cylindrical", "The patch is ruled, and its rulings are parallel."},
    {"planar", "All points lie in one plane. Of a mesh: the corners of each face do."},
    {"partition_of_unity", "The functions add up to 1 identically."},
    {"nonnegative", "None of the functions is negative anywhere on the domain."},
    {"minimax",
     "The parameter value stated makes the maximum of $|E|$ over the domain least, among those "
     "allowed."},
};

}  // namespace

std::vector<GlossaryEntry> glossary(const std::vector<std::string>& predicates) {
  std::vector<GlossaryEntry> found;
  std::ranges::copy_if(entries, std::back_inserter(found), [&](const GlossaryEntry& entry) {
    return std::ranges::find(predicates, entry.predicate) != predicates.end();
  });
  return found;
}

}  // namespace seam::report
