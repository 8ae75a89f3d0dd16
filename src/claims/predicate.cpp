// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "claims/builtin.h"
#include "claims/stating.h"
#include "geometry/contact.h"
#include "geometry/similarity.h"
#include "geometry/truncation.h"
#include "symbolic/coefficients.h"

// Predicates of the language by name, and statements that a file defines.

namespace seam::claims {
namespace {

using geometry::Criterion;
using geometry::Curve;
using geometry::Patch;
using geometry::Property;
using geometry::Surface;

constexpr int max_order = 8;

struct Arguments {
  Evaluator& evaluator;
  const Expression& at;
  geometry::Search search;
  std::vector<Value> values;

  const Expression& place(std::size_t i) const { return at.children[i + 1]; }
  const Numbers& numbers() const { return evaluator.numbers; }
  const Patch& patch(std::size_t i) const {
    const auto* found = values[i].as<Patch>();
    if (!found) fail(place(i), "expected a patch, found " + description(values[i]));
    if (found->dimension() != 3)
      fail(place(i), "expected a patch in space, with three coordinates");
    return *found;
  }
  const Surface& surface(std::size_t i) const {
    const auto* found = values[i].as<Surface>();
    if (!found)
      fail(place(i), "expected a surface, found " + description(values[i]),
           "surface([p, q]) and orbit(p, G) are surfaces");
    return *found;
  }
  const geometry::Mesh& mesh(std::size_t i) const {
    const auto* found = values[i].as<geometry::Mesh>();
    if (values[i].as<AnyMesh>() || values[i].as<IteratedMesh>())
      throw Unsupported("this predicate of " + description(values[i]));
    if (!found) fail(place(i), "expected a mesh, found " + description(values[i]));
    require_faces(*found, place(i));
    return *found;
  }
  int order(std::size_t i) const {
    const long order = as_integer(evaluator, values[i], place(i));
    if (order < 0 || order > max_order)
      fail(place(i), "expected an order from 0 to " + std::to_string(max_order));
    return static_cast<int>(order);
  }
};

using Predicate = Criterion (*)(const Arguments&);
struct Entry {
  int least, most;
  Predicate state;
};

Criterion regular(const Arguments& a) {
  return {geometry::regular(a.patch(0))};
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

const std::map<std::string, Entry>& table() {
  static const std::map<std::string, Entry> all = {
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
      {"connected", {1, 1, of_mesh<Property::connected>}},
      {"manifold", {1, 1, of_mesh<Property::manifold>}},
      {"orientable", {1, 1, of_mesh<Property::orientable>}},
      {"trivalent", {1, 1, trivalent}},
      {"oriented", {1, 1, of_mesh<Property::oriented>}},
      {"similar", {2, 2, similar}},
      {"congruent", {2, 2, congruent}}};
  return all;
}

const std::set<std::string>& later() {
  static const std::set<std::string> names = {"pregeodesic", "developable", "ruled",
                                              "cylindrical"};
  return names;
}

// The variables of an atom that it does not range over itself.
std::set<std::string> open_variables(const Proposition& atom) {
  std::set<std::string> open;
  if (const auto* zero = std::get_if<symbolic::Zero>(&atom.atom))
    open = symbolic::variables(zero->formula);
  if (const auto* sign = std::get_if<symbolic::Sign>(&atom.atom)) {
    open = symbolic::variables(sign->formula);
    for (const auto& factor : sign->domain.factors)
      for (const std::string& v : factor.variables) open.erase(v);
  }
  open.erase(geometry::parameter_u);
  open.erase(geometry::parameter_v);
  return open;
}

bool mentions_variables(const Proposition& p) {
  if (p.kind == Proposition::Kind::atom) return !open_variables(p).empty();
  return std::ranges::any_of(p.parts, mentions_variables);
}

bool is_plain_conjunction(const Proposition& p) {
  if (p.kind == Proposition::Kind::atom) return true;
  return p.kind == Proposition::Kind::all && std::ranges::all_of(p.parts, is_plain_conjunction);
}

// That no identity holds for all values of the variables.
bool are_identities(const std::vector<Proposition>& parts) {
  return std::ranges::all_of(parts, [](const Proposition& part) {
    return part.kind == Proposition::Kind::atom &&
           std::holds_alternative<symbolic::Zero>(part.atom);
  });
}

// A quotient vanishes where its numerator does.
geometry::Search searching(const Context& context, Evaluator& evaluator) {
  const auto vanishes = [&numbers = evaluator.numbers](const Formula& f) {
    return symbolic::vanishes(scalar_of(f, numbers).numerator, numbers);
  };
  geometry::Search search{evaluator.numbers, vanishes, {}};
  for (const long weight : {1, 3, 8})
    search.samples.push_back(sample(context, evaluator, weight));
  return search;
}

// What has to hold where its failure would not refute the predicate: then the claim is
// undecided.
void collect_guards(const Proposition& p, Criterion::Failure failure,
                    std::vector<Proposition>& guards) {
  if (failure == Criterion::Failure::refutes) return;
  for (const Proposition& part : p.parts) collect_guards(part, failure, guards);
  if (p.kind == Proposition::Kind::atom && (failure == Criterion::Failure::says_nothing ||
                                            !std::holds_alternative<symbolic::Zero>(p.atom)))
    guards.push_back(p);
}

}  // namespace

std::vector<std::string> predicate_names() {
  std::vector<std::string> names(later().begin(), later().end());
  names.insert(names.end(), {"partition_of_unity", "nonnegative"});
  for (const auto& predicate : table()) names.push_back(predicate.first);
  return names;
}

Proposition Stating::called(const Expression& e, const Scope& scope, const Context& context,
                            bool positive) {
  const bool bare = e.kind == Expression::Kind::name;
  const Expression& callee = bare ? e : e.children[0];
  const std::size_t given = bare ? 0 : e.children.size() - 1;
  if (callee.kind != Expression::Kind::name) fail(e, "expected a statement, found a value");
  const std::string& name = callee.text;

  if (const auto found = evaluator.globals.find(name); found != evaluator.globals.end()) {
    const Definition& definition = found->second;
    if (definition.broken) throw Broken();
    if (!definition.item || definition.item->kind != Item::Kind::define)
      fail(e, "expected a statement, found the value '" + name + "'");
    const Item& item = *definition.item;
    if (item.parameters.size() != given)
      fail(e, "'" + name + "' takes " + std::to_string(item.parameters.size()) +
                  " arguments, found " + std::to_string(given));
    Scope inner;
    for (std::size_t i = 0; i < given; ++i)
      inner.values[item.parameters[i]] = evaluator.evaluate(e.children[i + 1], scope);
    return state(item.expressions[0], inner, context, positive);
  }

  if (!bare && is_about_functions(e)) {
    if (!positive && !context.empty())
      throw Unsupported("this predicate negated for all values of a parameter");
    Proposition p = about_functions(e, scope, context);
    return positive ? p : symbolic::negation(std::move(p));
  }

  const auto entry = table().find(name);
  if (entry == table().end()) {
    if (later().contains(name))
      throw Unsupported("the predicate '" + name + "' is not covered yet");
    std::vector<std::string> known = predicate_names();
    for (const auto& global : evaluator.globals) known.push_back(global.first);
    const std::vector<std::string> functions = builtin_names();
    if (std::ranges::find(functions, name) != functions.end())
      fail(e, "expected a statement, found a value of '" + name + "'");
    const std::string near = text::nearest(name, known);
    fail(callee, "unknown predicate '" + name + "'",
         near.empty() ? "" : "did you mean '" + near + "'?");
  }
  Arguments arguments{evaluator, e, searching(context, evaluator), {}};
  if (static_cast<int>(given) < entry->second.least ||
      static_cast<int>(given) > entry->second.most)
    fail(e, "'" + name + "' takes " + std::to_string(entry->second.least) +
                (entry->second.most > entry->second.least
                     ? " or " + std::to_string(entry->second.most)
                     : "") +
                (entry->second.most == 1 ? " argument" : " arguments") + ", found " +
                std::to_string(given));
  for (std::size_t i = 0; i < given; ++i)
    arguments.values.push_back(evaluator.evaluate(e.children[i + 1], scope));
  predicates.insert(name);
  if (!context.where.empty()) throw Unsupported("a predicate under a condition");
  auto [p, failure] = entry->second.state(arguments);
  const bool open = mentions_variables(p);
  const bool refuted_for_all = p.kind == Proposition::Kind::any && are_identities(p.parts) &&
                               failure == Criterion::Failure::refutes;
  if (open && (!positive || (!is_plain_conjunction(p) && !refuted_for_all)))
    throw Unsupported(
        "this predicate for all values of a parameter: it is negated, or not along one pair of "
        "sides that is one curve for all of them");
  std::vector<Proposition> necessary;
  collect_guards(p, failure, necessary);
  for (Proposition& guard : necessary) guards.push_back(settled(std::move(guard), context, e));
  p = settled(std::move(p), context, e);
  return positive ? p : symbolic::negation(std::move(p));
}

}  // namespace seam::claims
