// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/winding.h"

#include "exact/contract.h"

// Let the sectors 0 .. k-1 be in cyclic order, d_i the direction in which the common side of
// sectors i-1 and i leaves the corner, d_k = d_0. A patch lies between the two sides of its
// corner: where it is regular, near the corner it covers, to first order, the combinations of
// d_i and d_(i+1) with coefficients >= 0. By the seams all these directions lie in one plane.
// Let n = d_0 x d_1, and state
//
//   (1) n.(d_i x d_(i+1)) > 0                                       for every i,
//   (2) n.(d_i x d_0) < 0  or  n.(d_0 x d_(i+1)) <= 0               for i = 2 .. k-2.
//
// By (1) no d_i is 0, and d_(i+1) is d_i turned about n by an angle t_i in (0, pi), so the
// sectors follow one another in one sense; they come back to d_0, so the sum of the t_i is 2 pi
// m, m >= 1. Turning all round sweeps over the direction d_0 m times, once in each sector that
// holds it, where a sector holds its first direction and not its last. With d_0 at the angle s
// in [0, 2 pi) from d_i,
//
//   n.(d_i x d_0) >= 0  and  n.(d_0 x d_(i+1)) > 0   mean   sin s >= 0  and  sin(t_i - s) > 0;
//
// the first gives s <= pi, so t_i - s > -pi, and the second then t_i - s > 0: they mean s <
// t_i, that sector i holds d_0. Sector 0 holds it. Sector 1 does not, by (1) for i = 0 (for k
// >= 3), nor does the last, d_0 being its end. So m = 1 exactly if (2) holds.
//
// With m = 1 the projections of the patches to the tangent plane fill a neighbourhood of the
// corner once: there the surface is a graph. With m > 1 it covers it m times, and is not a
// surface there.
//
// One or two sectors fail, rightly: (1) asks for n.(d_0 x d_0) > 0, or for n.(d_0 x d_1) and
// n.(d_1 x d_0) both > 0; regular patches have angles below pi, two do not close up.

namespace seam::geometry {
namespace {

using symbolic::all;
using symbolic::any;
using symbolic::atom;
using symbolic::Proposition;
using symbolic::Relation;

// Up to a positive factor the derivative of the side in the direction that leaves the corner.
Point direction(const Surface& s, const Corner::Sector& sector) {
  const Curve side = edge(s.patches[sector.patch], sector.side_in);
  const auto& p = side.control;
  if (p.size() < 2) return Point(p[0].size());
  return sector.in_starts_here ? p[1] - p[0] : p[p.size() - 2] - p[p.size() - 1];
}

Proposition sign(const Formula& number, Relation relation, std::string about) {
  return atom(symbolic::Sign{number, relation, {}}, std::move(about));
}

std::string title(const Corner& corner) {
  std::string result = "round the corner of patches";
  for (std::size_t i = 0; i < corner.sectors.size(); ++i)
    result += (i == 0 ? " " : ", ") + std::to_string(corner.sectors[i].patch + 1);
  return result;
}

}  // namespace

Proposition winds_once(const Surface& s, const Corner& corner) {
  exact::require(corner.closed, "winds_once: an open corner");
  std::vector<Point> d;
  for (const Corner::Sector& sector : corner.sectors) d.push_back(direction(s, sector));
  const int k = static_cast<int>(d.size());
  d.push_back(d[0]);

  const Point n = cross(d[0], d[1]);
  std::vector<Proposition> parts;
  parts.reserve(2 * d.size());
  for (int i = 0; i < k; ++i)
    parts.push_back(sign(dot(n, cross(d[i], d[i + 1])), Relation::positive,
                         "the sectors turn in one sense"));
  for (int i = 2; i <= k - 2; ++i)
    parts.push_back(any({sign(dot(n, cross(d[i], d[0])), Relation::negative, {}),
                         sign(dot(n, cross(d[0], d[i + 1])), Relation::nonpositive, {})},
                        "no other sector holds the direction of the first side"));
  return all(std::move(parts), title(corner));
}

}  // namespace seam::geometry
