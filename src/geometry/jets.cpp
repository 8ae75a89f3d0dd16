// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/contact.h"
#include "geometry/powers.h"

// G(k). Let p and q have their common side at v = 0, both at v > 0, and be G1 along it. Wanted
// are functions a_1, b_1, … of u with
//
//   q(u + A, B) = p(u, s) + O(s^(k+1)),   A = a_1 s + a_2 s^2 + …,   B = b_1 s + …,   b_1 < 0:
//
// q, reparametrised, is a continuation of p with equal derivatives across the side, hence (by
// differentiating along it) with equal k-jets. A reparametrisation that maps the side into
// itself fixes its points, for q(u,0) = p(u,0) runs through each once near by; so nothing is
// lost. (J. Peters, Geometric continuity, Handbook of Computer Aided Geometric Design, 2002, 2;
// P. Kiciak, Geometric Continuity of Curves and Surfaces, 2017, 3.)
//
// The coefficient of s^j, with p_j = D2^j p / j! and q_mn = D1^m D2^n q / (m! n!) at v = 0:
//
//   a_j q_10 + b_j q_01 = p_j - sum over m+n >= 2 of q_mn [s^j] A^m B^n.
//
// The right side holds a_i and b_i for i < j only. By G1 N = q_10 x q_01 is never 0, so there
// are such a_j and b_j exactly if the right side is orthogonal to N, and Cramer's rule gives
// them. They have powers of D = N.N for denominators: put a_j = x_j / D^(2j-1), b_j = y_j /
// D^(2j-1). Then [s^j] A^m B^n = D^(m+n-2j) [s^j] X^m Y^n, and times D^(2j-2) the right side is
//
//   F_j = D^(2j-2) p_j - sum over m+n >= 2 of D^(m+n-2) q_mn [s^j] X^m Y^n,
//   (1) N.F_j = 0,   x_j = (F_j x q_01).N,   y_j = (q_10 x F_j).N.
//
// Stated are G1 and (1) for j = 2 .. k, identically in u. (1) for j = 1 and b_1 < 0 are what G1
// says: N.p_1 is the determinant there, and y_1 = (T x A).(T x B). (1) for j = 2 and G1 are G2:
// N.p_vv is that of the reparametrised q, so the second forms agree across; and as p_v = a_1
// q_u
// + b_1 q_v for all u, its derivative along the side gives N.p_uv = a_1 N.q_uu + b_1 N.q_uv:
// they agree along and across. The condition of order j makes sense only with those below;
// where one of these fails, so does G(k), whatever the later ones say.
//
// Curves, x at its end and y at its beginning, likewise, with b_1 > 0: T = y', D = T.T,
//
//   b_j y_1 = x_j - sum over n >= 2 of y_n [s^j] B^n,   F_j = D^(2j-2) x_j - …,
//   D F_j = (F_j.T) T,   y_j = F_j.T.

namespace seam::geometry {
namespace {

using symbolic::all;
using symbolic::atom;
using symbolic::Zero;

Formula inverse_factorial(int n) {
  exact::Integer value;
  mpz_fac_ui(value.get_mpz_t(), n);
  return Formula(exact::Rational(exact::Integer(1), value));
}

std::string of_order(const char* what, int j) {
  return std::string(what) + " of order " + std::to_string(j);
}

Proposition vanishes(const Point& vector, const std::string& about) {
  std::vector<Proposition> parts;
  for (const Formula& coordinate : vector) parts.push_back(atom(Zero{coordinate}, about));
  return all(std::move(parts));
}

// F_j of two patches.
Point right_side(const Contact& c, int j, const Formula& d, Powers& powers) {
  Point result = power(d, 2 * j - 2) * (inverse_factorial(j) * along_side(c.p, 0, j));
  for (int r = 2; r <= j; ++r)
    for (int m = 0; m <= r; ++m) {
      const Formula share = inverse_factorial(m) * inverse_factorial(r - m) * power(d, r - 2) *
                            powers.coefficient(j, m, r - m);
      result = result - share * along_side(c.q, m, r - m);
    }
  return result;
}

// … and of two curves.
Point right_side(const Curve& x, const Curve& y, int j, const Formula& d, Powers& powers) {
  Point result = power(d, 2 * j - 2) * (inverse_factorial(j) * derivative(x, j, 1));
  for (int n = 2; n <= j; ++n) {
    const Formula share = inverse_factorial(n) * power(d, n - 2) * powers.coefficient(j, 0, n);
    result = result - share * derivative(y, n, 0);
  }
  return result;
}

}  // namespace

Proposition equal_jets(const Contact& c, int order) {
  if (order == 0) return g0(c);
  std::vector<Proposition> parts{g1(c)};
  const Point along = along_side(c.q, 1, 0), across = along_side(c.q, 0, 1);
  const Point n = cross(along, across);
  const Formula d = norm2(n);
  Powers powers;
  for (int j = 1; j <= order; ++j) {
    const Point f = right_side(c, j, d, powers);
    if (j > 1) parts.push_back(atom(Zero{dot(n, f)}, of_order("equal jets", j)));
    powers.extend(dot(cross(f, across), n), dot(cross(along, f), n));
  }
  return all(std::move(parts));
}

Proposition equal_jets(const Curve& x, const Curve& y, int order) {
  std::vector<Proposition> parts{
      vanishes(evaluate(x, 1) - evaluate(y, 0), "the first ends where the second begins")};
  if (order == 0) return all(std::move(parts));
  const Point t = derivative(y, 1, 0);
  const Formula d = norm2(t);
  parts.push_back(
      atom(symbolic::Sign{dot(derivative(x, 1, 1), t), symbolic::Relation::positive, {}},
           "regular, and in one direction"));
  Powers powers;
  for (int j = 1; j <= order; ++j) {
    const Point f = right_side(x, y, j, d, powers);
    parts.push_back(vanishes(d * f - dot(f, t) * t, of_order("equal jets", j)));
    powers.extend(0, dot(f, t));
  }
  return all(std::move(parts));
}

}  // namespace seam::geometry
