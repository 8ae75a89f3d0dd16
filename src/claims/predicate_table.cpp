// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/predicate_table.h"

#include <algorithm>

#include "claims/builtin.h"
#include "claims/stating.h"
#include "geometry/similarity.h"
#include "geometry/surface_shape.h"
#include "geometry/truncation.h"
#include "symbolic/coefficients.h"

// What each predicate of the language says of its arguments.

namespace seam::claims {
namespace {

using geometry::Criterion;
using geometry::Curve;
using geometry::Patch;
using geometry::Property;
using geometry::Surface;

Criterion regular(const Arguments& a) {
  if (a.values[0].as<Patch>()) return {geometry::regular(a.patch(0))};
  return {geometry::regular(a.chart(0))};
}
Criterion developable(const Arguments& a) {
  return geometry::developable(a.chart(0), a.search);
}
Criterion ruled(const Arguments& a) {
  return geometry::ruled(a.chart(0), a.search);
}
Criterion cylindrical(const Arguments& a) {
  return geometry::cylindrical(a.chart(0), a.search);
}

// The third argument names the parameter that is constant on the curve: s or u the first, t or
// v the second.
Criterion pregeodesic(const Arguments& a) {
  const Expression& at = a.place(2);
  const std::string& name = at.text;
  const bool first = name == "s" || name == "u";
  if (at.kind != Expression::Kind::named || (!first && name != "t" && name != "v"))
    fail(at, "expected which parameter is constant on the curve", "write 's = 0' or 't = 1'");
  const Formula value = as_number(a.evaluator, a.values[2], at);
  const auto number = a.numbers().rational(value);
  if (!number) fail(at, "expected a rational value of the parameter");
  const geometry::Chart y = a.chart(1);
  const bool is_triangle = y.domain.factors.size() == 1;
  if (!y.domain.factors.empty() && (*number < 0 || (is_triangle ? *number >= 1 : *number > 1)))
    fail(at, "this value of the parameter is outside the patch");
  return geometry::pregeodesic(a.arc(0), y, first, Formula(*number));
}

// Two patches from the first argument on that is one.
Criterion meeting(const Arguments& a, std::size_t first, const geometry::Condition& condition) {
  return geometry::along_a_common_side(a.patch(first), a.patch(first + 1), condition, a.search);
}
Criterion g0(const Arguments& a) {
  return meeting(a, 0, [](const geometry::Contact& c) { return geometry::g0(c); });
}
Criterion g1(const Arguments& a) {
  if (a.values.size() == 1) return {geometry::g1(a.surface(0), a.numbers())};
  return meeting(a, 0, [](const geometry::Contact& c) { return geometry::g1(c); });
}
Criterion g2(const Arguments& a) {
  if (a.values.size() == 1) return {geometry::g2(a.surface(0), a.numbers())};
  return meeting(a, 0, [](const geometry::Contact& c) { return geometry::g2(c); });
}

// Two curves, if the second argument is one.
std::optional<std::pair<Curve, Curve>> curves(const Arguments& a) {
  const auto *x = a.values[1].as<Curve>(), *y = a.values[2].as<Curve>();
  if (!x) return std::nullopt;
  if (!y) fail(a.place(2), "expected a curve, found " + description(a.values[2]));
  if (x->control[0].size() != y->control[0].size())
    fail(a.place(2), "these curves lie in spaces of different dimensions");
  return std::pair(*x, *y);
}
Criterion g_of_order(const Arguments& a) {
  const int order = a.order(0);
  if (const auto pair = curves(a))
    return {geometry::equal_jets(pair->first, pair->second, order)};
  return meeting(a, 1,
                 [=](const geometry::Contact& c) { return geometry::equal_jets(c, order); });
}
Criterion c_of_order(const Arguments& a) {
  const int order = a.order(0);
  if (const auto pair = curves(a))
    return {geometry::equal_derivatives(pair->first, pair->second, order)};
  if (a.patch(1).shape() != a.patch(2).shape())
    fail(a.place(2), "equal derivatives are for two triangle patches or two quad patches");
  return meeting(
      a, 1, [=](const geometry::Contact& c) { return geometry::equal_derivatives(c, order); });
}

// A mesh that is truncated `least` times or more: as it is then, or, where some vertex has
// other than three edges, once again; from there on by induction.
Criterion planar_for_ever(const IteratedMesh& m) {
  std::vector<Proposition> parts;
  if (const auto* any = std::get_if<AnyMesh>(&m.mesh)) {
    if (!any->planar || !any->trivalent)
      throw Unsupported(
          "the planarity of an arbitrary mesh that is not supposed planar and 3-valent");
  } else {
    geometry::Mesh mesh = std::get<geometry::Mesh>(m.mesh);
    for (long k = 0; k < m.least; ++k) mesh = geometry::truncate(mesh, m.ratio);
    const auto at = [&](long k) {
      return "base: " + m.parameter + " = " + std::to_string(m.first + k);
    };
    parts.push_back(geometry::has(mesh, Property::planar, {}, at(0)));
    const bool trivalent = geometry::is_trivalent(mesh);
    if (!trivalent) {
      mesh = geometry::truncate(mesh, m.ratio);
      parts.push_back(geometry::has(mesh, Property::planar, {}, at(1)));
    }
    parts.push_back(geometry::has(mesh, Property::valences, geometry::valences(mesh),
                                  at(trivalent ? 0 : 1)));
  }
  parts.push_back(geometry::planarity_step(m.ratio));
  return {symbolic::all(std::move(parts))};
}

bool is_mesh(const Value& value) {
  return value.as<geometry::Mesh>() || value.as<AnyMesh>() || value.as<IteratedMesh>();
}

template <Property property>
Criterion of_mesh(const Arguments& a) {
  return {geometry::has(a.mesh(0), property)};
}

Criterion closed(const Arguments& a) {
  if (is_mesh(a.values[0])) return of_mesh<Property::closed>(a);
  return {geometry::closed(a.surface(0), a.numbers())};
}
Criterion convex(const Arguments& a) {
  if (is_mesh(a.values[0])) return of_mesh<Property::convex>(a);
  return {geometry::convex(a.surface(0), a.numbers())};
}

Criterion interpolates(const Arguments& a) {
  const auto* patch = a.values[0].as<Patch>();
  const Surface s = patch ? glue({a.patch(0)}, a.place(0), a.numbers()) : a.surface(0);
  auto points = a.values[1].as<geometry::Mesh>()
                    ? a.values[1].as<geometry::Mesh>()->vertices
                    : as_points(a.evaluator, a.values[1], a.place(1));
  if (points.empty()) fail(a.place(1), "no points to interpolate");
  if (points[0].size() != 3) fail(a.place(1), "expected points with three coordinates");
  for (const auto& point : points)
    for (const Formula& entry : point)
      if (!symbolic::is_number(entry))
        throw Unsupported("interpolation of points that hold variables");
  return {geometry::interpolates(s, points, a.numbers())};
}

Criterion trivalent(const Arguments& a) {
  if (const auto* any = a.values[0].as<AnyMesh>()) {
    if (any->trivalent) return {symbolic::truth()};
    throw Unsupported("the valences of an arbitrary mesh");
  }
  const int vertices = static_cast<int>(a.mesh(0).vertices.size());
  return {
      geometry::has(a.mesh(0), Property::valences, {3, vertices}, "every vertex is 3-valent")};
}

Criterion planar(const Arguments& a) {
  if (const auto* m = a.values[0].as<IteratedMesh>()) return planar_for_ever(*m);
  if (const auto* any = a.values[0].as<AnyMesh>())
    return planar_for_ever({*any, Formula::symbol("r~"), 0, {}, 0});
  if (a.values[0].as<geometry::Mesh>()) return of_mesh<Property::planar>(a);
  const auto points = as_points(a.evaluator, a.values[0], a.place(0));
  if (points.empty() || points[0].size() != 3)
    fail(a.place(0), "expected points with three coordinates");
  return {geometry::planar(points)};
}
// The search looks for patches carried to patches with their parameters; that it finds nothing
// refutes nothing, for the same point set may have other parameters.
void require_similar(const Arguments& a) {
  if (!geometry::find_similarity(a.surface(0), a.surface(1), a.evaluator.numbers))
    throw Unsupported("no similarity was found that carries patches to patches");
}
Criterion similar(const Arguments& a) {
  require_similar(a);
  return {geometry::similar(a.surface(0), a.surface(1), a.evaluator.numbers)};
}
Criterion congruent(const Arguments& a) {
  require_similar(a);
  return {geometry::congruent(a.surface(0), a.surface(1), a.evaluator.numbers)};
}

}  // namespace

const std::map<std::string, PredicateEntry>& predicate_table() {
  static const std::map<std::string, PredicateEntry> all = {
      {"regular", {1, 1, regular}},
      {"G0", {2, 2, g0}},
      {"G1", {1, 2, g1}},
      {"G2", {1, 2, g2}},
      {"G", {3, 3, g_of_order}},
      {"C", {3, 3, c_of_order}},
      {"closed", {1, 1, closed}},
      {"convex", {1, 1, convex}},
      {"interpolates", {2, 2, interpolates}},
      {"planar", {1, 1, planar}},
      {"developable", {1, 1, developable}},
      {"ruled", {1, 1, ruled}},
      {"cylindrical", {1, 1, cylindrical}},
      {"pregeodesic", {3, 3, pregeodesic}},
      {"connected", {1, 1, of_mesh<Property::connected>}},
      {"manifold", {1, 1, of_mesh<Property::manifold>}},
      {"orientable", {1, 1, of_mesh<Property::orientable>}},
      {"trivalent", {1, 1, trivalent}},
      {"oriented", {1, 1, of_mesh<Property::oriented>}},
      {"similar", {2, 2, similar}},
      {"congruent", {2, 2, congruent}}};
  return all;
}

}  // namespace seam::claims
