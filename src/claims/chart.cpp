// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/chart.h"

// A function `let y(s, t) = ...` is a surface over the whole plane: its text is evaluated at
// the parameters of geometry, which no name of a file can be.

namespace seam::claims {
namespace {

using geometry::parameter_u;
using geometry::parameter_v;
using symbolic::Point;

Point point_of(const std::vector<Scalar>& components) {
  Point point;
  for (const Scalar& component : components) point.push_back(formula_of(component));
  return point;
}

// The value of a function of so many numbers, at the parameters.
std::optional<Point> point_of(Evaluator& evaluator, const Value& value,
                              const std::vector<std::string>& parameters) {
  const auto* function = value.as<Function>();
  if (!function || function->item->kind != Item::Kind::let ||
      function->item->parameters.size() != parameters.size())
    return std::nullopt;
  Scope scope;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    scope.values[function->item->parameters[i]] = {Scalar(Formula::symbol(parameters[i]))};
  const Expression& body = function->item->expressions[0];
  const Value result = evaluator.evaluate(body, scope);
  if (const auto* scalar = result.as<Scalar>()) return point_of({*scalar});
  if (const auto* vector = result.as<Vector>()) return point_of(*vector);
  return std::nullopt;
}

}  // namespace

symbolic::Domain domain_of(geometry::Patch::Shape shape) {
  if (shape == geometry::Patch::Shape::triangle)
    return {{symbolic::standard_simplex({parameter_u, parameter_v})}, {}};
  return {{symbolic::interval(parameter_u, 0, 1), symbolic::interval(parameter_v, 0, 1)}, {}};
}

std::optional<geometry::Chart> chart_of(Evaluator& evaluator, const Value& value) {
  if (const auto* patch = value.as<geometry::Patch>()) return geometry::chart(*patch);
  if (const auto* field = value.as<Field>())
    return geometry::chart(point_of(field->components), domain_of(field->shape));
  if (const auto point = point_of(evaluator, value, {parameter_u, parameter_v}))
    return geometry::chart(*point, {});
  return std::nullopt;
}

std::optional<geometry::Arc> arc_of(Evaluator& evaluator, const Value& value) {
  if (const auto* curve = value.as<geometry::Curve>()) return geometry::arc(*curve);
  if (const auto* field = value.as<CurveField>())
    return geometry::arc(point_of(field->components), field->is_segment);
  if (const auto point = point_of(evaluator, value, {parameter_u}))
    return geometry::arc(*point, false);
  return std::nullopt;
}

}  // namespace seam::claims
