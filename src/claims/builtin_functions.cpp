// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>
#include <set>

#include "claims/variable.h"

namespace seam::claims {
namespace {

Value each_scalar(const Value& value, const std::function<Scalar(const Scalar&)>& f) {
  if (const auto* scalar = value.as<Scalar>()) return {f(*scalar)};
  if (const auto* vector = value.as<Vector>()) {
    Vector result;
    for (const Scalar& entry : *vector) result.push_back(f(entry));
    return {result};
  }
  if (const auto* field = value.as<Field>()) {
    Field result{field->shape, {}};
    for (const Scalar& entry : field->components) result.components.push_back(f(entry));
    return {result};
  }
  return {List{}};
}

// What the function rests on the derivative rests on too.
Scalar derivative(const Scalar& s, const std::string& symbol, Numbers& numbers) {
  return scalar_of(symbolic::diff(formula_of(s), symbol), numbers);
}

// A derivative is some times as large as the function, one of order 20 past all bounds. Parts
// that are shared count once.
void require_small(const Scalar& s) {
  constexpr std::size_t most_parts = 20'000;
  std::set<const void*> parts;
  const std::function<void(const Formula&)> count = [&](const Formula& f) {
    if (!parts.insert(f.identity()).second) return;
    if (parts.size() > most_parts) throw Unsupported("a derivative that becomes too large");
    for (const Formula& operand : f.operands()) count(operand);
  };
  for (const Formula& divisor : s.divisors) count(divisor);
  count(s.numerator);
  count(s.denominator);
}

// The parameters of a function on a patch have no names.
void refuse_field(const Call& call, const Value& value) {
  if (value.as<Field>())
    fail(call[0], "a function on a patch has no named variable",
         "give it arguments: 'gauss(p)(u, v)'");
}

Value mapped(const Call& call, const Value& value,
             const std::function<Scalar(const Scalar&)>& f) {
  if (!value.as<Scalar>() && !value.as<Vector>() && !value.as<Field>())
    fail(call[0], "expected a function, found " + description(value));
  return each_scalar(value, f);
}

bool mentions(const Value& value, const std::string& symbol) {
  const auto in = [&](const Scalar& s) {
    return symbolic::symbols(s.numerator).contains(symbol) ||
           symbolic::symbols(s.denominator).contains(symbol);
  };
  if (const auto* scalar = value.as<Scalar>()) return in(*scalar);
  const auto* vector = value.as<Vector>();
  return vector && std::ranges::any_of(*vector, in);
}

Value diff(const Call& call) {
  const Variable variable(call, call[1]);
  const long order = call.count() == 3 ? call.integer(2) : 1;
  if (order < 0 || order > 100) fail(call[2], "expected an order from 0 to 100");
  Value value = call.evaluator.evaluate(call[0], variable.scope());
  refuse_field(call, value);
  for (long k = 0; k < order; ++k)
    value = mapped(call, value, [&](const Scalar& s) {
      if (k > 0) require_small(s);
      return derivative(s, variable.symbol(), call.evaluator.numbers);
    });
  if (variable.is_fresh() && mentions(value, variable.symbol()))
    fail(call[1], "the variable '" + call[1].text + "' is not bound here");
  return value;
}

// subst(E, u = 1/3, v = 0), all at once.
Value subst(const Call& call) {
  std::map<std::string, Scalar> map;
  std::vector<std::unique_ptr<Variable>> variables;
  Scope inner{&call.scope, {}};
  for (std::size_t i = 1; i < call.count(); ++i) {
    if (call[i].kind != Expression::Kind::named) fail(call[i], "expected 'variable = value'");
    Expression name{Expression::Kind::name, call[i].text, {}, call[i].span};
    variables.push_back(std::make_unique<Variable>(call, name));
    inner.values[call[i].text] = {Scalar(Formula::symbol(variables.back()->symbol()))};
    map[variables.back()->symbol()] = call.evaluator.scalar(call[i].children[0], call.scope);
  }
  const Value value = call.evaluator.evaluate(call[0], inner);
  refuse_field(call, value);
  return mapped(call, value,
                [&](const Scalar& s) { return substitute(s, map, call.evaluator.numbers); });
}

// Of a rational number, in lowest terms; of a function as it is written, not reduced.
std::optional<exact::Rational> rational_argument(const Call& call, const Value& value) {
  const auto* scalar = value.as<Scalar>();
  if (!scalar || !is_number(*scalar)) return std::nullopt;
  const auto rational = call.evaluator.numbers.rational(scalar->numerator);
  if (!rational) throw Unsupported("the numerator or denominator of an irrational number");
  return rational;
}

// Of a quotient of polynomials it is a polynomial; of another function it has a value only
// where the function has one.
Scalar part(const Scalar& whole, const Formula& formula) {
  Scalar result(formula);
  if (!whole.numerator.is_polynomial() || !whole.denominator.is_polynomial())
    result.divisors = whole.divisors;
  result.radicands = whole.radicands;
  return result;
}

// For an integer that is not known it would be another thing than for each one.
Value argument(const Call& call) {
  const Value value = call.value(0);
  const auto* scalar = value.as<Scalar>();
  if (scalar && holds_integer(call.evaluator, *scalar))
    throw Unsupported("the numerator or denominator of a number with an integer parameter");
  return value;
}

Value numerator(const Call& call) {
  const Value value = argument(call);
  if (const auto rational = rational_argument(call, value))
    return {Scalar(Formula(exact::Rational(rational->get_num())))};
  return mapped(call, value, [](const Scalar& s) { return part(s, s.numerator); });
}
Value denominator(const Call& call) {
  const Value value = argument(call);
  if (const auto rational = rational_argument(call, value))
    return {Scalar(Formula(exact::Rational(rational->get_den())))};
  return mapped(call, value, [](const Scalar& s) { return part(s, s.denominator); });
}

}  // namespace

const Builtins& function_builtins() {
  static const Builtins table = {{"diff", {2, 3, diff}},
                                 {"subst", {2, -1, subst}},
                                 {"numerator", {1, 1, numerator}},
                                 {"denominator", {1, 1, denominator}}};
  return table;
}

}  // namespace seam::claims
