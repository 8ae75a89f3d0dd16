// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "claims/builtin.h"
#include "claims/stating.h"

// Predicates of lists of functions. A segment that blends the points p_0, ..., p_m goes over
// into that of p_1, ..., p_{m+1} where, whatever the points are,
//
//   sum B_i(1) p_i = sum B_i(0) p_{i+1},  so  B_0(1) = 0, B_i(1) = B_{i-1}(0), B_m(0) = 0,
//
// and likewise for derivatives.

namespace seam::claims {
namespace {

constexpr long max_order = 8;

struct Functions {
  std::vector<Scalar> values;  ///< in geometry::parameter_u and parameter_v
  int arguments = 0;
  bool triangle = false;
};

const std::string& parameter(int i) {
  return i == 0 ? geometry::parameter_u : geometry::parameter_v;
}

class Reading {
 public:
  Reading(Evaluator& evaluator, const Expression& at, const Scope& scope)
      : evaluator_(evaluator), at_(at), scope_(scope) {}

  // `u` and `v` stand for the variables of the functions, where they stand for nothing else.
  Functions run() {
    Scope inner{&scope_, {}};
    const std::vector<std::string> taken = names();
    for (int i = 0; i < 2; ++i) {
      const std::string name = i == 0 ? "u" : "v";
      if (std::ranges::find(taken, name) == taken.end())
        inner.values[name] = {Scalar(Formula::symbol(parameter(i)))};
    }
    add(evaluator_.evaluate(at_, inner));
    if (result_.values.empty()) fail(at_, "a list without a function");
    return std::move(result_);
  }

 private:
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const Scope* s = &scope_; s; s = s->outer)
      for (const auto& entry : s->values) all.push_back(entry.first);
    for (const auto& entry : evaluator_.globals) all.push_back(entry.first);
    return all;
  }

  void add(const Value& value) {
    if (const auto* scalar = value.as<Scalar>()) return add(*scalar, 0);
    if (const auto* curve = value.as<CurveField>()) return add(single(curve->components), 1);
    if (const auto* field = value.as<Field>()) {
      result_.triangle |= field->shape == geometry::Patch::Shape::triangle;
      return add(single(field->components), 2);
    }
    if (const auto* function = value.as<Function>()) return add(called(*function->item));
    // A matrix or a vector would pass for a list of constant functions.
    const auto* list = value.as<List>();
    if (!list)
      fail(at_, "expected a list of functions, found " + description(value),
           "the functions of a matrix M are blending(M)");
    for (const Value& item : list->items) add(item);
  }
  void add(const Scalar& function, int arguments) {
    for (int i = 0; i < 2; ++i)
      if (symbolic::variables(function.numerator * function.denominator).contains(parameter(i)))
        arguments = std::max(arguments, i + 1);
    result_.values.push_back(function);
    result_.arguments = std::max(result_.arguments, arguments);
  }
  const Scalar& single(const std::vector<Scalar>& components) const {
    if (components.size() != 1) fail(at_, "expected functions whose values are numbers");
    return components.front();
  }
  Value called(const Item& item) {
    if (item.kind != Item::Kind::let || item.parameters.size() > 2)
      fail(at_, "'" + item.name + "' is no function of one or two variables");
    Scope inner;
    for (std::size_t i = 0; i < item.parameters.size(); ++i)
      inner.values[item.parameters[i]] = {
          Scalar(Formula::symbol(parameter(static_cast<int>(i))))};
    result_.arguments = std::max(result_.arguments, static_cast<int>(item.parameters.size()));
    return evaluator_.evaluate(item.expressions[0], inner);
  }

  Evaluator& evaluator_;
  const Expression& at_;
  const Scope& scope_;
  Functions result_;
};

// All points of the domain that is given, or of that of the functions.
Context over(Evaluator& evaluator, const Functions& functions, const Expression* domain,
             const Scope& scope, Context context) {
  const std::vector<std::string> both = {geometry::parameter_u, geometry::parameter_v};
  if (!domain) {
    if (functions.triangle)
      context.factors.push_back(symbolic::standard_simplex(both));
    else
      for (int i = 0; i < std::max(functions.arguments, 1); ++i)
        context.factors.push_back(symbolic::interval(parameter(i), 0, 1));
    return context;
  }
  if (evaluator.is_interval(*domain, scope)) {
    if (functions.arguments > 1)
      fail(*domain, "an interval is no domain for functions of two variables");
    context.factors.push_back(evaluator.continuous_set(*domain, {parameter(0)}, scope));
    return context;
  }
  const Value value = evaluator.evaluate(*domain, scope);
  const auto* region = value.as<Region>();
  if (!region || region->dimension != 2)
    fail(*domain, "expected 'triangle', 'square' or an interval");
  if (region->square)
    for (const std::string& name : both)
      context.factors.push_back(
          symbolic::interval(name, 0, 1, region->interior, region->interior));
  else
    context.factors.push_back(symbolic::standard_simplex(both, region->interior));
  return context;
}

}  // namespace

bool Stating::is_about_functions(const Expression& call) {
  const std::string& name = call.children[0].text;
  return name == "partition_of_unity" || name == "nonnegative" ||
         (name == "C" && call.children.size() == 3);
}

Proposition Stating::about_functions(const Expression& e, const Scope& scope,
                                     const Context& context) {
  const std::string& name = e.children[0].text;
  const std::size_t given = e.children.size() - 1;
  if (given < 1 || given > 2) fail(e, "'" + name + "' takes one or two arguments");
  predicates.insert(name);
  if (name == "C") return continuous(e, scope, context);
  const Functions functions = Reading(evaluator, e.children[1], scope).run();
  const Context inner =
      over(evaluator, functions, given == 2 ? &e.children[2] : nullptr, scope, context);
  std::vector<Proposition> parts;
  if (name == "nonnegative") {
    for (std::size_t i = 0; i < functions.values.size(); ++i) {
      parts.push_back(compare(e, {functions.values[i]}, ">=", {Scalar(0)}, inner, true));
      parts.back().about = "function " + std::to_string(i + 1) + " is not negative";
    }
    return symbolic::all(std::move(parts));
  }
  Scalar sum;
  for (const Scalar& function : functions.values) sum = sum + function;
  return symbolic::all({compare(e, {sum}, "=", {Scalar(1)}, inner, true)},
                       "the functions add up to 1");
}

// C(k, L)
Proposition Stating::continuous(const Expression& e, const Scope& scope,
                                const Context& context) {
  const long order = evaluator.integer(e.children[1], scope);
  if (order < 0 || order > max_order)
    fail(e.children[1], "expected an order from 0 to " + std::to_string(max_order));
  Functions functions = Reading(evaluator, e.children[2], scope).run();
  if (functions.arguments > 1) fail(e.children[2], "expected functions of one variable");
  std::vector<Proposition> parts;
  for (long k = 0; k <= order; ++k) {
    const auto at = [&](std::size_t i, long u) {
      return Value{substitute(functions.values[i], {{geometry::parameter_u, Scalar(u)}},
                              evaluator.numbers)};
    };
    const auto demand = [&](const Value& a, const Value& b, const std::string& words) {
      parts.push_back(compare(e, a, "=", b, context, true));
      parts.back().about = "derivative " + std::to_string(k) + ": " + words;
    };
    const std::size_t last = functions.values.size() - 1;
    demand(at(0, 1), {Scalar(0)}, "the first function is 0 at 1");
    for (std::size_t i = 0; i < last; ++i)
      demand(at(i, 0), at(i + 1, 1),
             "function " + std::to_string(i + 1) + " at 0, the next one at 1");
    demand(at(last, 0), {Scalar(0)}, "the last function is 0 at 0");
    for (Scalar& f : functions.values)
      f = scalar_of(symbolic::diff(formula_of(f), geometry::parameter_u), evaluator.numbers);
  }
  return symbolic::all(std::move(parts));
}

}  // namespace seam::claims
