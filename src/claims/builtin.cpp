// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/builtin.h"

#include <array>

namespace seam::claims {
namespace {

std::array<const Builtins*, 11> tables() {
  return {&number_builtins(),      &elementary_builtins(), &function_builtins(),
          &coefficient_builtins(), &vector_builtins(),     &patch_builtins(),
          &solid_builtins(),       &mesh_builtins(),       &extremum_builtins(),
          &minimax_builtins(),     &spline_builtins()};
}

using Solid = geometry::Mesh (*)(Numbers&);
const std::map<std::string, Solid>& solids() {
  static const std::map<std::string, Solid> all = {{"tetrahedron", geometry::tetrahedron},
                                                   {"cube", geometry::cube},
                                                   {"octahedron", geometry::octahedron},
                                                   {"dodecahedron", geometry::dodecahedron},
                                                   {"icosahedron", geometry::icosahedron}};
  return all;
}

}  // namespace

std::optional<Value> builtin(Evaluator& evaluator, const std::string& name,
                             const Expression& at, const Scope& scope) {
  if (name == "simplex" && at.children.size() == 2) {
    const long n = evaluator.integer(at.children[1], scope);
    if (n < 1 || n > 8) fail(at, "a simplex has a dimension from 1 to 8 here");
    return Value{Region{false, static_cast<int>(n), false}};
  }
  if (name == "interior" && at.children.size() == 2) {
    const Value value = evaluator.evaluate(at.children[1], scope);
    const auto* region = value.as<Region>();
    if (!region) fail(at, "expected a domain, found " + description(value));
    return Value{Region{region->square, region->dimension, true}};
  }
  for (const Builtins* table : tables()) {
    const auto found = table->find(name);
    if (found == table->end()) continue;
    const Call call{evaluator, at, scope};
    const auto& [least, most, apply] = found->second;
    const int given = static_cast<int>(call.count());
    if (given < least || (most >= 0 && given > most)) {
      const std::string wanted = least == most ? std::to_string(least)
                                 : most < 0
                                     ? "at least " + std::to_string(least)
                                     : std::to_string(least) + " to " + std::to_string(most);
      fail(at, "'" + name + "' takes " + wanted + (wanted == "1" ? " argument" : " arguments") +
                   ", found " + std::to_string(given));
    }
    return apply(call);
  }
  return std::nullopt;
}

std::vector<std::string> builtin_names() {
  std::vector<std::string> names = {"triangle", "square", "simplex", "interior", "pi"};
  for (const Builtins* table : tables())
    for (const auto& entry : *table) names.push_back(entry.first);
  for (const auto& entry : solids()) names.push_back(entry.first);
  return names;
}

std::optional<Value> builtin_word(Evaluator& evaluator, const std::string& name) {
  if (const auto found = solids().find(name); found != solids().end())
    return Value{found->second(evaluator.numbers)};
  if (name == "triangle") return Value{Region{}};
  if (name == "pi") return Value{Scalar(evaluator.numbers.pi())};
  if (name == "square") return Value{Region{true, 2, false}};
  return std::nullopt;
}

}  // namespace seam::claims
