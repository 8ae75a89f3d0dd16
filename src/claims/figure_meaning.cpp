// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "claims/chart.h"
#include "claims/item_reader.h"
#include "claims/latex.h"

// A figure shows values as they are, or functions over a domain that is said with them. What
// has no single value, because it holds a parameter, is not drawn, and the figure says so.

namespace seam::claims {
namespace {

using geometry::parameter_u;
using geometry::parameter_v;

const std::string over_a_domain = "say over which domain: 'f(u, v) for (u,v) in triangle'";

bool has_a_picture(const Value& value) {
  return value.as<geometry::Patch>() || value.as<geometry::Surface>() ||
         value.as<geometry::Mesh>() || value.as<geometry::Curve>();
}

bool is_same(const geometry::Patch& a, const geometry::Patch& b) {
  if (a.shape() != b.shape() || a.degree_u() != b.degree_u() || a.degree_v() != b.degree_v() ||
      a.dimension() != b.dimension())
    return false;
  for (std::size_t j = 0; j < a.rows().size(); ++j)
    for (std::size_t i = 0; i < a.rows()[j].size(); ++i)
      if (!std::ranges::equal(a.rows()[j][i], b.rows()[j][i],
                              [](const Formula& x, const Formula& y) { return x.same(y); }))
        return false;
  return true;
}

// As a patch, or as one of a surface.
bool shows(const MeantFigure& figure, const geometry::Patch& patch) {
  return std::ranges::any_of(figure.values, [&](const Value& value) {
    if (const auto* one = value.as<geometry::Patch>()) return is_same(*one, patch);
    const auto* surface = value.as<geometry::Surface>();
    return surface && std::ranges::any_of(surface->patches,
                                          [&](const auto& p) { return is_same(p, patch); });
  });
}

bool has_no_single_value(const Value& value) {
  return value.as<AnyMesh>() || value.as<IteratedMesh>();
}

// One function or several, each a number or a point in the plane or in space.
std::vector<Vector> functions_of(const Value& value, const Expression& at) {
  if (const auto* scalar = value.as<Scalar>()) return {{*scalar}};
  if (const auto* vector = value.as<Vector>(); vector && vector->size() <= 3) return {*vector};
  if (const auto* list = value.as<List>()) {
    std::vector<Vector> result;
    for (const Value& item : list->items)
      for (Vector& function : functions_of(item, at)) result.push_back(std::move(function));
    if (!result.empty()) return result;
  }
  fail(at, "over a domain a number, or a point of two or three coordinates is drawn, not " +
               description(value));
}

// Graphs over a plane domain are coloured by their own values.
std::optional<MeantFigure::Colour> own_colour(const MeantFigure::Functions& shown,
                                              const Expression& e) {
  const Expression& head = e.kind == Expression::Kind::each ? e.children[0] : e;
  MeantFigure::Colour result{format(head), latex(head)};
  for (const Vector& function : shown.functions) {
    if (function.size() != 1) return std::nullopt;
    result.formulas.push_back(formula_of(function[0]));
  }
  const std::size_t variables = shown.domain.size() == 1 ? shown.domain[0].variables.size() : 2;
  if (variables == 1) return std::nullopt;
  return result;
}

bool is_bounded(const symbolic::Simplex& simplex) {
  return std::ranges::none_of(simplex.corners, [](const auto& c) { return c[0].is(0); });
}

}  // namespace

MeantFigure::Functions Reader::functions(const Expression& each, Scope& scope) {
  MeantFigure::Functions result;
  std::size_t variables = 0;
  for (std::size_t i = 1; i < each.children.size(); ++i) {
    const Expression& binding = each.children[i];
    if (const Expression* condition = condition_of(binding))
      fail(*condition, "a figure shows a function on all of its domain",
           "leave the condition out");
    std::vector<std::string> symbols;
    for (const Expression& name : binding.children[0].children) {
      symbols.push_back(evaluator_.bind(name.text));
      scope.values[name.text] = {Scalar(Formula::symbol(symbols.back()))};
    }
    variables += symbols.size();
    result.domain.push_back(evaluator_.continuous_set(binding.children[1], symbols, scope));
    if (!is_bounded(result.domain.back()))
      fail(binding.children[1], "a figure shows a bounded domain", "give both ends");
  }
  if (variables > 2)
    fail(each, "a figure shows functions of one or two variables, not of " +
                   std::to_string(variables));
  result.functions =
      functions_of(evaluator_.evaluate(each.children[0], scope), each.children[0]);
  return result;
}

void Reader::show(MeantFigure& figure, const Expression& shown) {
  const Value value = evaluator_.evaluate(shown, Scope{});
  const auto* list = value.as<List>();
  for (const Value& item : list ? list->items : std::vector<Value>{value}) {
    if (has_a_picture(item))
      figure.values.push_back(item);
    else if (has_no_single_value(item))
      throw Unsupported(description(item) + ", of which there are many");
    else if (const auto* field = item.as<Field>(); field && !list)
      figure.functions = {domain_of(field->shape).factors, {field->components}};
    else if (const auto* on_curve = item.as<CurveField>(); on_curve && !list)
      figure.functions = {{symbolic::interval(parameter_u, 0, 1)}, {on_curve->components}};
    else
      fail(shown, description(item) + " has no picture",
           item.as<Function>() || item.as<Scalar>() || item.as<Vector>() ? over_a_domain : "");
  }
}

// `gauss`, `mean`, `corners`, or an expression in the parameters u, v of a patch (of functions:
// their variables) and the coordinates x, y, z of the point.
MeantFigure::Colour Reader::colour(const MeantFigure& figure, const Expression& e,
                                   const Scope& around) {
  MeantFigure::Colour result{format(e), latex(e)};
  if (e.kind == Expression::Kind::name &&
      (e.text == "gauss" || e.text == "mean" || e.text == "corners"))
    return result;
  Scope scope{&around, {}};
  if (!figure.functions) {
    scope.values["u"] = {Scalar(Formula::symbol(parameter_u))};
    scope.values["v"] = {Scalar(Formula::symbol(parameter_v))};
  }
  for (const std::string name : {"x", "y", "z"}) {
    result.position.push_back(evaluator_.bind(name));
    if (!around.values.contains(name))
      scope.values[name] = {Scalar(Formula::symbol(result.position.back()))};
  }
  const Value value = evaluator_.evaluate(e, scope);
  const auto add = [&](const Vector& components) {
    if (components.size() != 1) fail(e, "a colour stands for a number, not for a vector");
    result.formulas.push_back(formula_of(components[0]));
  };
  if (const auto* surface = value.as<SurfaceField>()) {
    for (const Field& field : surface->fields) add(field.components);
    const auto* shown =
        figure.values.size() == 1 ? figure.values[0].as<geometry::Surface>() : nullptr;
    if (!shown || shown->patches.size() != surface->fields.size())
      fail(e, "this function is one on another surface");
  } else if (const auto* field = value.as<Field>()) {
    add(field->components);
  } else if (const auto* scalar = value.as<Scalar>()) {
    add({*scalar});
  } else {
    fail(e, "a colour stands for a number, not for " + description(value),
         "write 'gauss', 'mean', or an expression in u, v and x, y, z");
  }
  return result;
}

void Reader::figure(const Item& item) {
  if (!item.name.empty()) add_id(item.name, item.name_span);
  MeantFigure result{item.name, item.claim.title, item.claim.at, {}, {}, {}, {}, item.names,
                     {}};
  const std::set<std::string> bound = evaluator_.bound_symbols();
  try {
    Scope scope;
    const Expression& shown = item.expressions[0];
    within_limits(item.span, "", "what it shows", [&] {
      if (shown.kind == Expression::Kind::each)
        result.functions = functions(shown, scope);
      else
        show(result, shown);
    });
    for (const auto& [name, definition] : evaluator_.globals)
      if (const auto* patch =
              definition.value ? definition.value->as<geometry::Patch>() : nullptr;
          patch && shows(result, *patch))
        result.named.emplace(name, *patch);
    if (item.expressions.size() > 1)
      within_limits(item.span, ", coloured", "its colour",
                    [&] { result.colour = colour(result, item.expressions[1], scope); });
    else if (result.functions)
      result.colour = own_colour(*result.functions, shown);
  } catch (const Problem& problem) {
    report(problem.diagnostic);
  } catch (const Unsupported& unsupported) {
    result.unsupported = unsupported.what();
  } catch (const symbolic::NumberLimit& limit) {
    result.unsupported = limit.what();
  } catch (const Broken&) {
  }
  evaluator_.bind_only(bound);
  meaning_.items.push_back(std::move(result));
}

}  // namespace seam::claims
