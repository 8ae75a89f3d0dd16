// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/contract.h"
#include "geometry/contact.h"

// C(k). Let p and q have their common side at v = 0, run through in one direction, both at v >
// 0. Their domains are laid side by side by an affine map that carries the side of one to that
// of the other: q lives on v < 0, and its point (u, v) is put
//
//   of squares at (u, -v): then D2^j q = (-1)^j D2^j p along the side,
//   of triangles at (u + v, -v), which carries the corner (0,1) to (1,-1): the two triangles
//   make a parallelogram, whichever of the corners of the side is called (0,0). Then D2^j q =
//   (D1 - D2)^j p along the side.
//
// For j = 0 .. k: differentiating along the side gives all other derivatives to order k.
// (G. Farin, Curves and Surfaces for CAGD, 15.2 and 17.6, with domains of this shape.)

namespace seam::geometry {
namespace {

using symbolic::all;
using symbolic::atom;
using symbolic::Zero;

Formula binomial(int n, int k) {
  exact::Integer value;
  mpz_bin_uiui(value.get_mpz_t(), n, k);
  return Formula(exact::Rational(value));
}

Proposition equal(const Point& a, const Point& b, int order) {
  std::vector<Proposition> parts;
  for (const Formula& difference : a - b)
    parts.push_back(
        atom(Zero{difference}, "equal derivatives of order " + std::to_string(order)));
  return all(std::move(parts));
}

// The derivative of order j of p in the direction into which q runs across the side.
Point onward(const Patch& p, int j) {
  const Formula sign = j % 2 == 0 ? 1 : -1;
  Point result = sign * along_side(p, 0, j);
  if (p.shape() == Patch::Shape::triangle)
    for (int i = 1; i <= j; ++i)
      result = result + (i % 2 == 0 ? sign : -sign) * binomial(j, i) * along_side(p, i, j - i);
  return result;
}

}  // namespace

Proposition equal_derivatives(const Contact& c, int order) {
  exact::require(c.p.shape() == c.q.shape(), "equal_derivatives: patches of two shapes");
  std::vector<Proposition> parts;
  for (int j = 0; j <= order; ++j)
    parts.push_back(equal(onward(c.p, j), along_side(c.q, 0, j), j));
  return all(std::move(parts));
}

Proposition equal_derivatives(const Curve& x, const Curve& y, int order) {
  std::vector<Proposition> parts;
  for (int j = 0; j <= order; ++j)
    parts.push_back(equal(derivative(x, j, 1), derivative(y, j, 0), j));
  return all(std::move(parts));
}

}  // namespace seam::geometry
