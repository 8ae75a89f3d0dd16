// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "claims/builtin.h"
#include "claims/stating.h"
#include "geometry/contact.h"
#include "geometry/similarity.h"

// Predicates of the language by name, and statements that a file defines.

namespace seam::claims {
namespace {

using geometry::Patch;
using geometry::Surface;

struct Arguments {
  Evaluator& evaluator;
  const Expression& at;
  std::vector<Value> values;

  const Expression& place(std::size_t i) const { return at.children[i + 1]; }
  const Patch& patch(std::size_t i) const {
    const auto* found = values[i].as<Patch>();
    if (!found) fail(place(i), "expected a patch, found " + description(values[i]));
    if (found->dimension() != 3)
      fail(place(i), "expected a patch in space, with three coordinates");
    return *found;
  }
  const Patch& numeric_patch(std::size_t i) const {
    for (const auto& row : patch(i).rows())
      for (const auto& point : row)
        for (const Formula& entry : point)
          if (!symbolic::is_number(entry))
            throw Unsupported(
                "contact of patches whose control points hold variables is not covered yet");
    return patch(i);
  }
  const Surface& surface(std::size_t i) const {
    const auto* found = values[i].as<Surface>();
    if (!found)
      fail(place(i), "expected a surface, found " + description(values[i]),
           "surface([p, q]) and orbit(p, G) are surfaces");
    return *found;
  }
};

using Predicate = Proposition (*)(const Arguments&);
struct Entry {
  int least, most;
  Predicate state;
};

Proposition regular(const Arguments& a) {
  return geometry::regular(a.patch(0));
}
Proposition g0(const Arguments& a) {
  return geometry::g0(a.numeric_patch(0), a.numeric_patch(1), a.evaluator.numbers);
}
Proposition g1(const Arguments& a) {
  if (a.values.size() == 1) return geometry::g1(a.surface(0), a.evaluator.numbers);
  return geometry::g1(a.numeric_patch(0), a.numeric_patch(1), a.evaluator.numbers);
}
Proposition g2(const Arguments& a) {
  if (a.values.size() == 1) return geometry::g2(a.surface(0), a.evaluator.numbers);
  return geometry::g2(a.numeric_patch(0), a.numeric_patch(1), a.evaluator.numbers);
}
Proposition closed(const Arguments& a) {
  return geometry::closed(a.surface(0), a.evaluator.numbers);
}
Proposition convex(const Arguments& a) {
  return geometry::convex(a.surface(0), a.evaluator.numbers);
}

Proposition interpolates(const Arguments& a) {
  const Surface& s = a.values[0].as<Patch>()
                         ? geometry::surface({a.numeric_patch(0)}, a.evaluator.numbers)
                         : a.surface(0);
  auto points = a.values[1].as<geometry::Mesh>()
                    ? a.values[1].as<geometry::Mesh>()->vertices
                    : as_points(a.evaluator, a.values[1], a.place(1));
  if (points.empty()) fail(a.place(1), "no points to interpolate");
  if (points[0].size() != 3) fail(a.place(1), "expected points with three coordinates");
  for (const auto& point : points)
    for (const Formula& entry : point)
      if (!symbolic::is_number(entry))
        throw Unsupported("interpolation of points that hold variables");
  return geometry::interpolates(s, points, a.evaluator.numbers);
}

Proposition planar(const Arguments& a) {
  const auto points = as_points(a.evaluator, a.values[0], a.place(0));
  if (points.empty() || points[0].size() != 3)
    fail(a.place(0), "expected points with three coordinates");
  return geometry::planar(points);
}
// The search looks for patches carried to patches with their parameters; that it finds nothing
// refutes nothing, for the same point set may have other parameters.
void require_similar(const Arguments& a) {
  if (!geometry::find_similarity(a.surface(0), a.surface(1), a.evaluator.numbers))
    throw Unsupported("no similarity was found that carries patches to patches");
}
Proposition similar(const Arguments& a) {
  require_similar(a);
  return geometry::similar(a.surface(0), a.surface(1), a.evaluator.numbers);
}
Proposition congruent(const Arguments& a) {
  require_similar(a);
  return geometry::congruent(a.surface(0), a.surface(1), a.evaluator.numbers);
}

const std::map<std::string, Entry>& table() {
  static const std::map<std::string, Entry> all = {{"regular", {1, 1, regular}},
                                                   {"G0", {2, 2, g0}},
                                                   {"G1", {1, 2, g1}},
                                                   {"G2", {1, 2, g2}},
                                                   {"closed", {1, 1, closed}},
                                                   {"convex", {1, 1, convex}},
                                                   {"interpolates", {2, 2, interpolates}},
                                                   {"planar", {1, 1, planar}},
                                                   {"similar", {2, 2, similar}},
                                                   {"congruent", {2, 2, congruent}}};
  return all;
}

const std::set<std::string>& later() {
  static const std::set<std::string> names = {
      "G",     "C",           "pregeodesic",        "developable",
      "ruled", "cylindrical", "partition_of_unity", "nonnegative"};
  return names;
}

// A predicate on patches with parameters of the file, or of a quantifier around, holds for all
// their values: their sets join the domain of every inequality. (An identity says so anyway.)
Proposition under(Proposition p, const Context& context,
                  const std::vector<Parameter>& parameters) {
  for (Proposition& part : p.parts) part = under(std::move(part), context, parameters);
  if (p.kind != Proposition::Kind::atom) return p;
  auto* sign = std::get_if<symbolic::Sign>(&p.atom);
  if (!sign) return p;
  std::set<std::string> open = symbolic::variables(sign->formula);
  for (const auto& factor : sign->domain.factors)
    for (const std::string& v : factor.variables) open.erase(v);
  const auto join = [&](const symbolic::Simplex& factor) {
    if (std::ranges::none_of(factor.variables, [&](const auto& v) { return open.contains(v); }))
      return;
    sign->domain.factors.push_back(factor);
    for (const std::string& v : factor.variables) open.erase(v);
  };
  for (const auto& factor : context.factors) join(factor);
  for (const Parameter& parameter : parameters)
    if (parameter.set) join(*parameter.set);
  if (!open.empty()) throw Unsupported("a predicate for all values of an unbounded parameter");
  return p;
}

bool mentions_variables(const Proposition& p) {
  if (p.kind == Proposition::Kind::atom) {
    const auto* sign = std::get_if<symbolic::Sign>(&p.atom);
    const auto* zero = std::get_if<symbolic::Zero>(&p.atom);
    std::set<std::string> open = sign   ? symbolic::variables(sign->formula)
                                 : zero ? symbolic::variables(zero->formula)
                                        : std::set<std::string>{};
    if (sign)
      for (const auto& factor : sign->domain.factors)
        for (const std::string& v : factor.variables) open.erase(v);
    open.erase(geometry::parameter_u);
    open.erase(geometry::parameter_v);
    return !open.empty();
  }
  return std::ranges::any_of(p.parts, mentions_variables);
}

bool is_plain_conjunction(const Proposition& p) {
  if (p.kind == Proposition::Kind::atom) return true;
  return p.kind == Proposition::Kind::all && std::ranges::all_of(p.parts, is_plain_conjunction);
}

}  // namespace

std::vector<std::string> predicate_names() {
  std::vector<std::string> names(later().begin(), later().end());
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
  Arguments arguments{evaluator, e, {}};
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
  Proposition p = entry->second.state(arguments);
  if (!context.where.empty()) throw Unsupported("a predicate under a condition");
  const bool open = mentions_variables(p);
  if (open && (!positive || !is_plain_conjunction(p)))
    throw Unsupported("this predicate for all values of a parameter");
  p = under(std::move(p), context, evaluator.parameters);
  return positive ? p : symbolic::negation(std::move(p));
}

}  // namespace seam::claims
