// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/surface_shape.h"

#include <algorithm>
#include <set>

// The sign of the Gauss curvature is that of (n.p_uu)(n.p_vv) - (n.p_uv)^2. On a surface
// p = a(v) + u b(v) the first product is 0, so the curvature is 0 exactly where n.p_uv is; and
// n.p_uv = det(b, a' + u b', b') = det(b, a', b') for every u, so u = 0 tells of all.
//
// Rulings b(v) with b x b' = 0 are parallel: where b is not 0, the direction b/|b| has the
// derivative 0. Polynomials that are not identically 0 vanish at finitely many points, and the
// direction is a quotient of polynomials; of other functions, and of families, it is asked that
// b is nowhere 0, which is more than is needed. And parallel rulings have b x b' = 0.
//
// x' and x'' are dependent exactly if x' x x'' = 0; if not, the vectors with v.(x' x x'') = 0
// are those of the plane of the two.

namespace seam::geometry {
namespace {

using symbolic::all;
using symbolic::any;
using symbolic::atom;
using symbolic::Relation;

Proposition is_zero(const Point& point, const std::string& about) {
  std::vector<Proposition> parts;
  for (const Formula& coordinate : point)
    parts.push_back(atom(symbolic::Zero{coordinate}, about));
  return all(std::move(parts), about);
}

bool vanishes(const Point& point, const Search& search) {
  return std::ranges::all_of(point, search.vanishes);
}

// In the parameters of a surface alone.
bool are_polynomials(const Point& point) {
  return std::ranges::all_of(point, [](const Formula& f) {
    std::set<std::string> others = symbolic::variables(f);
    others.erase(parameter_u);
    others.erase(parameter_v);
    return f.is_polynomial() && others.empty();
  });
}

// Without quotients and roots.
bool is_defined_everywhere(const Formula& f) {
  if (f.is_polynomial()) return true;
  if (f.kind() == Formula::Kind::inverse || f.kind() == Formula::Kind::root) return false;
  return std::ranges::all_of(f.operands(), is_defined_everywhere);
}

const std::string& parameter(bool first) {
  return first ? parameter_u : parameter_v;
}

Point at(Point point, const std::string& symbol, const Formula& value) {
  for (Formula& coordinate : point) coordinate = symbolic::subst(coordinate, {{symbol, value}});
  return point;
}

// The derivative in a ruling's own direction, and across.
Point along(const Chart& y, bool first, int times, int across) {
  return first ? y.derivative(times, across) : y.derivative(across, times);
}

bool is_linear(const Chart& y, bool first, const Search& search) {
  return vanishes(along(y, first, 2, 0), search);
}

std::string linear(bool first) {
  return std::string("linear in the ") + (first ? "first" : "second") + " parameter";
}

Proposition linear_in(const Chart& y, bool first) {
  return is_zero(along(y, first, 2, 0), linear(first));
}

}  // namespace

Proposition regular(const Chart& y) {
  return atom(symbolic::Sign{norm2(normal(y)), Relation::positive, y.domain},
              "the normal is nowhere 0");
}

Criterion developable(const Chart& y, const Search& search) {
  const std::string about = "the Gauss curvature is 0";
  for (const bool first : {true, false}) {
    if (!is_linear(y, first, search)) continue;
    Point ruling = along(y, first, 1, 0), across = along(y, first, 0, 1),
          turn = along(y, first, 1, 1);
    if (std::ranges::all_of(y.derivative(0, 0), is_defined_everywhere))
      for (Point* vector : {&ruling, &across, &turn})
        *vector = at(std::move(*vector), parameter(first), 0);
    return {all({linear_in(y, first),
                 atom(symbolic::Zero{dot(cross(ruling, across), turn)}, about)}),
            Criterion::Failure::refutes, normal(y)};
  }
  return {atom(symbolic::Zero{gauss(y).numerator}, about), Criterion::Failure::refutes,
          normal(y)};
}

Criterion ruled(const Chart& y, const Search& search) {
  for (const bool first : {true, false})
    if (is_linear(y, first, search)) return {linear_in(y, first)};
  return {any({linear_in(y, true), linear_in(y, false)})};
}

Criterion cylindrical(const Chart& y, const Search& search) {
  std::vector<Proposition> ways;
  Criterion::Failure failure = Criterion::Failure::refutes;
  for (const bool first : {true, false}) {
    const Point ruling = along(y, first, 1, 0);
    const Point turn = cross(ruling, along(y, first, 1, 1));
    Proposition way = all({linear_in(y, first), is_zero(turn, "the rulings are parallel")});
    if (is_linear(y, first, search) && vanishes(turn, search)) {
      if (are_polynomials(ruling)) return {std::move(way), Criterion::Failure::refutes, ruling};
      way.parts.push_back(atom(symbolic::Sign{norm2(ruling), Relation::positive, y.domain},
                               "there are rulings"));
      return {std::move(way), Criterion::Failure::refutes_by_identities};
    }
    if (!std::ranges::all_of(ruling, &Formula::is_polynomial)) {
      way.parts.push_back(atom(symbolic::Sign{norm2(ruling), Relation::positive, y.domain},
                               "there are rulings"));
      failure = Criterion::Failure::refutes_by_identities;
    }
    ways.push_back(std::move(way));
  }
  return {any(std::move(ways)), failure};
}

Criterion pregeodesic(const Arc& x, const Chart& y, bool first, const Formula& value) {
  const Formula t = Formula::symbol(parameter(!first));
  const auto on_curve = [&](int order) { return at(x.derivative(order), parameter_u, t); };
  const auto on_surface = [&](const Point& p) { return at(p, parameter(first), value); };
  symbolic::Domain domain;
  if (x.is_segment)
    domain.factors = {symbolic::interval(parameter(!first), 0, 1)};
  else if (y.domain.factors.size() == 1)  // a triangle
    domain.factors = {symbolic::interval(parameter(!first), 0, Formula(1) - value)};
  else if (!y.domain.factors.empty())
    domain.factors = {symbolic::interval(parameter(!first), 0, 1)};
  const Point binormal = cross(on_curve(1), on_curve(2)), n = on_surface(normal(y));
  return {all(
      {is_zero(on_surface(y.derivative(0, 0)) - on_curve(0), "the curve lies on the surface"),
       atom(symbolic::Sign{norm2(binormal), Relation::positive, domain},
            "x' and x'' are independent"),
       atom(symbolic::Sign{norm2(n), Relation::positive, domain},
            "the normal vanishes nowhere along the curve"),
       atom(symbolic::Zero{dot(n, binormal)}, "the normal lies in the plane of x' and x''")})};
}

}  // namespace seam::geometry
