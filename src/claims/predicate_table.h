// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "claims/builtin.h"
#include "claims/chart.h"
#include "geometry/contact.h"

namespace seam::claims {

inline constexpr int max_predicate_order = 8;

/// A predicate that is called: its arguments, evaluated, or an error that says what was
/// expected.
struct Arguments {
  Evaluator& evaluator;
  const Expression& at;
  geometry::Search search;
  std::vector<Value> values;

  const Expression& place(std::size_t i) const { return at.children[i + 1]; }
  const Numbers& numbers() const { return evaluator.numbers; }
  const geometry::Patch& patch(std::size_t i) const {
    const auto* found = values[i].as<geometry::Patch>();
    if (!found) fail(place(i), "expected a patch, found " + description(values[i]));
    if (found->dimension() != 3)
      fail(place(i), "expected a patch in space, with three coordinates");
    return *found;
  }
  const geometry::Surface& surface(std::size_t i) const {
    const auto* found = values[i].as<geometry::Surface>();
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
  geometry::Chart chart(std::size_t i) const {
    auto found = chart_of(evaluator, values[i]);
    if (!found)
      fail(place(i), "expected a patch, found " + description(values[i]),
           "a patch, or a function of two numbers");
    if (found->derivative(0, 0).size() != 3)
      fail(place(i), "expected a patch in space, with three coordinates");
    return *found;
  }
  geometry::Arc arc(std::size_t i) const {
    auto found = arc_of(evaluator, values[i]);
    if (!found)
      fail(place(i), "expected a curve, found " + description(values[i]),
           "a curve, or a function of one number");
    if (found->derivative(0).size() != 3)
      fail(place(i), "expected a curve in space, with three coordinates");
    return *found;
  }
  int order(std::size_t i) const {
    const long order = as_integer(evaluator, values[i], place(i));
    if (order < 0 || order > max_predicate_order)
      fail(place(i), "expected an order from 0 to " + std::to_string(max_predicate_order));
    return static_cast<int>(order);
  }
};

using Predicate = geometry::Criterion (*)(const Arguments&);
/// How many arguments it takes, and what it says.
struct PredicateEntry {
  int least, most;
  Predicate state;
};

const std::map<std::string, PredicateEntry>& predicate_table();

}  // namespace seam::claims
