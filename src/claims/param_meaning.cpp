// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "claims/any_mesh.h"
#include "claims/item_reader.h"
#include "claims/parameters.h"

// A parameter is a symbol, or a vector of symbols, with a set; a condition belongs to all the
// symbols of its item. An integer parameter has its values from the statements that hold it.

namespace seam::claims {

bool is_taken(const std::string& name) {
  std::vector<std::string> taken = builtin_names();
  for (std::string& predicate : predicate_names()) taken.push_back(std::move(predicate));
  return std::ranges::find(taken, name) != taken.end();
}

// Its components are named like those of a symbolic point; nothing else has that name.
std::optional<Value> Reader::arbitrary_function(const std::string& name,
                                                const FunctionType& type, const Item& item) {
  if (!item.expressions.empty() || item.where || type.arguments < 1 || type.arguments > 2 ||
      type.components < 1 || type.components > 100) {
    report({item.span, "expected a function of 1 or 2 numbers, with no set and no condition",
            "what is said of it under an assumption is stated with 'implies'"});
    return std::nullopt;
  }
  std::vector<Formula> operands = {Formula::symbol(geometry::parameter_u)};
  if (type.arguments == 2) operands.push_back(Formula::symbol(geometry::parameter_v));
  std::vector<Scalar> components;
  for (int i = 1; i <= type.components; ++i) {
    const std::string function =
        evaluator_.bind(type.components == 1 ? name : name + "[" + std::to_string(i) + "]");
    components.push_back(scalar_of(Formula::applied(function, operands), *meaning_.numbers));
  }
  if (type.arguments == 1) return Value{CurveField{std::move(components), false}};
  return Value{Field{geometry::Patch::Shape::square, std::move(components)}};
}

Definition Reader::parameter(const Item& item, const std::string& name) {
  Definition definition{&item, {}, {}, false, {}};
  if (item.type == "integer") {
    definition.holds_integers = true;
    evaluator_.bind(name);
    evaluator_.integers.known.emplace(name, &item);
    return definition;
  }
  if (item.type == "mesh") {
    definition.value = Value{any_mesh(evaluator_, name)};
    return definition;
  }
  if (const auto type = FunctionType::of(item.type)) {
    definition.value = arbitrary_function(name, *type, item);
    definition.broken = !definition.value;
    return definition;
  }
  if (!item.type.empty()) {
    const exact::Integer size(item.type.substr(item.type.find_first_of("0123456789")));
    if (size < 1 || size > 100) {
      report({item.span, "expected a vector of 1 to 100 entries", {}});
      definition.broken = true;
      return definition;
    }
    Vector vector;
    for (long i = 1; i <= size.get_si(); ++i) {
      const std::string symbol = evaluator_.bind(name + "[" + std::to_string(i) + "]");
      evaluator_.parameters.push_back({symbol, std::nullopt, {}});
      vector.push_back(Scalar(Formula::symbol(symbol)));
    }
    definition.value = Value{vector};
    return definition;
  }
  const std::string symbol = evaluator_.bind(name);
  Parameter parameter{symbol, std::nullopt, {}};
  evaluator_.sides.clear();
  if (!item.expressions.empty())
    parameter.set = evaluator_.continuous_set(item.expressions[0], {symbol}, Scope{});
  evaluator_.parameters.push_back(parameter);
  definition.value = Value{Scalar(Formula::symbol(symbol))};
  definition.sides = evaluator_.sides;
  return definition;
}

// The condition holds for the symbols of all names of the item; and some values meet it.
void Reader::set_condition(const Item& item) {
  if (item.type == "integer") {
    const IntegerRange range = integer_range(evaluator_, item.names.front());
    if (range.low && range.high && *range.low > *range.high)
      fail(item.where ? *item.where : item.expressions[0], "no integer is in this set");
    return;
  }
  if (!item.where) return;
  if (item.type == "mesh") return suppose(evaluator_, item);
  Stating stating(evaluator_);
  const auto condition = stating.constraints(*item.where, Scope{}, {}, true);
  if (!condition) fail(*item.where, "a condition after 'where' compares polynomials");
  std::set<std::string> symbols;
  for (const std::string& name : item.names) {
    const std::optional<Value>& value = evaluator_.globals.at(name).value;
    if (!value) throw Broken();
    for (const Value& entry : value->as<Vector>() ? as_items(evaluator_, *value, *item.where)
                                                  : std::vector<Value>{*value})
      symbols.merge(symbolic::variables(entry.as<Scalar>()->numerator));
  }
  for (const symbolic::Constraint& c : *condition)
    if (symbolic::variables(c.formula).empty())
      fail(*item.where, "this condition says nothing of the parameter");
  for (Parameter& parameter : evaluator_.parameters)
    if (symbols.contains(parameter.name)) parameter.where = *condition;
  for (const std::string& name : item.names) {
    auto& sides = evaluator_.globals.at(name).sides;
    sides.insert(sides.end(), stating.guards.begin(), stating.guards.end());
  }
  if (!is_inhabited(evaluator_, symbols))
    throw Unsupported("no value of the parameter was found that meets its condition");
}

void Reader::define_param(const Item& item) {
  meaning_.items.push_back(MeantDefinition{item});
  std::vector<std::string> names;
  const auto attempt = [&](const std::string& name, const std::function<void()>& action) {
    std::string unsupported, why = "unsupported";
    bool broken = false;
    try {
      return within_limits(item.span, ", " + name, defined(item, item.names.front()), action);
    } catch (const Problem& problem) {
      report(problem.diagnostic);
      broken = true;
    } catch (const IntegerMet&) {
      if (item.type == "integer") return;
      unsupported = "a condition that compares a real parameter with an integer one";
    } catch (const Unsupported& reason) {
      unsupported = reason.what();
      why = reason.reason;
    } catch (const symbolic::NumberLimit& limit) {
      unsupported = limit.what();
    } catch (const Broken&) {
      broken = true;
    }
    for (const std::string& each : names) {
      evaluator_.globals[each].broken |= broken;
      if (unsupported.empty()) continue;
      evaluator_.globals[each].unsupported = unsupported;
      evaluator_.globals[each].reason = why;
    }
  };
  for (const std::string& name : item.names) {
    if (evaluator_.globals.contains(name) || is_taken(name)) {
      report({item.span, "'" + name + "' is defined already", "choose another name"});
      continue;
    }
    names.push_back(name);
    attempt(name, [&] { evaluator_.globals[name] = parameter(item, name); });
  }
  if (names.size() == item.names.size()) attempt("where", [&] { set_condition(item); });
}

}  // namespace seam::claims
