// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/curvature.h"

// With E = p_u.p_u, F = p_u.p_v, G = p_v.p_v and e = (n.p_uu)/|n|, f = (n.p_uv)/|n|, g =
// (n.p_vv)/|n|,
//
//   K = (e g - f^2) / (E G - F^2),   H = (e G - 2 f F + g E) / (2 (E G - F^2)),
//
// and E G - F^2 = n.n by Lagrange (do Carmo, Differential Geometry of Curves and
// Surfaces, 3.3).

namespace seam::geometry {
namespace {

// The second fundamental form times |n|.
struct SecondForm {
  Formula uu, uv, vv;
};

SecondForm second_form(const Patch& p, const Point& n, const Formula& u, const Formula& v) {
  return {dot(n, derivative(p, 2, 0, u, v)), dot(n, derivative(p, 1, 1, u, v)),
          dot(n, derivative(p, 0, 2, u, v))};
}

}  // namespace

Quotient gauss(const Point& n, const Point& uu, const Point& uv, const Point& vv) {
  return {dot(n, uu) * dot(n, vv) - power(dot(n, uv), 2), power(norm2(n), 2)};
}

Quotient gauss(const Patch& p, const Formula& u, const Formula& v) {
  return gauss(normal(p, u, v), derivative(p, 2, 0, u, v), derivative(p, 1, 1, u, v),
               derivative(p, 0, 2, u, v));
}

Quotient mean_times_norm(const Patch& p, const Formula& u, const Formula& v) {
  const Point d1 = derivative(p, 1, 0, u, v), d2 = derivative(p, 0, 1, u, v);
  const Point n = cross(d1, d2);
  const SecondForm form = second_form(p, n, u, v);
  return {norm2(d2) * form.uu - 2 * dot(d1, d2) * form.uv + norm2(d1) * form.vv, 2 * norm2(n)};
}

}  // namespace seam::geometry
