// SPDX-License-Identifier: GPL-3.0-or-later
#include "draw/rounded_function.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

// Derivatives are carried along by the rules of product and chain, so none is a quotient of
// differences.

namespace seam::draw {
namespace {

using symbolic::Formula;
using Kind = Formula::Kind;

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

Expansion sum(const Expansion& a, const Expansion& b) {
  return {a.value + b.value, a.u + b.u, a.v + b.v, a.uu + b.uu, a.uv + b.uv, a.vv + b.vv};
}

Expansion product(const Expansion& a, const Expansion& b) {
  return {a.value * b.value,
          a.u * b.value + a.value * b.u,
          a.v * b.value + a.value * b.v,
          a.uu * b.value + 2 * a.u * b.u + a.value * b.uu,
          a.uv * b.value + a.u * b.v + a.v * b.u + a.value * b.uv,
          a.vv * b.value + 2 * a.v * b.v + a.value * b.vv};
}

// f(a), from f, f', f'' at the value of a.
Expansion chain(const Expansion& a, double f, double first, double second) {
  return {f,
          first * a.u,
          first * a.v,
          second * a.u * a.u + first * a.uu,
          second * a.u * a.v + first * a.uv,
          second * a.v * a.v + first * a.vv};
}

// x^n, its derivatives free of 0 * infinity at x = 0.
Expansion power(const Expansion& a, double n) {
  const double x = a.value;
  const double first = n == 0 ? 0 : n * std::pow(x, n - 1);
  const double second = n == 0 || n == 1 ? 0 : n * (n - 1) * std::pow(x, n - 2);
  return chain(a, std::pow(x, n), first, second);
}

Expansion applied(const std::string& function, const Expansion& a) {
  const double x = a.value;
  if (function == "exp") return chain(a, std::exp(x), std::exp(x), std::exp(x));
  if (function == "sin") return chain(a, std::sin(x), std::cos(x), -std::sin(x));
  if (function == "cos") return chain(a, std::cos(x), -std::sin(x), -std::cos(x));
  if (function == "log") return chain(a, std::log(x), 1 / x, -1 / (x * x));
  return {undefined, undefined, undefined, undefined, undefined, undefined};
}

}  // namespace

RoundedFunction::RoundedFunction(const Formula& formula,
                                 const std::vector<std::string>& variables,
                                 const symbolic::Numbers& numbers) {
  std::map<const void*, int> known;
  const auto add = [&](auto&& self, const Formula& f) -> int {
    if (const auto found = known.find(f.identity()); found != known.end()) return found->second;
    Step step{f.kind(), 0, 0, {}, {}};
    int variable = -1;
    switch (f.kind()) {
      case Kind::constant:
        step.constant = f.value().get_d();
        break;
      case Kind::symbol: {
        const auto place = std::ranges::find(variables, f.name());
        if (place != variables.end())
          variable = static_cast<int>(place - variables.begin());
        else
          step.constant = symbolic::is_generator(f.name()) ? numbers.approximate(f) : undefined;
        break;
      }
      case Kind::known:
        return known[f.identity()] = self(self, f.operands()[0]);
      case Kind::power:
      case Kind::root:
        step.exponent = f.exponent();
        [[fallthrough]];
      default:
        if (f.kind() == Kind::applied) step.name = f.name();
        for (const Formula& operand : f.operands())
          step.operands.push_back(self(self, operand));
    }
    steps_.push_back(std::move(step));
    variable_of_step_.push_back(variable);
    return known[f.identity()] = static_cast<int>(steps_.size()) - 1;
  };
  add(add, formula);
}

Expansion RoundedFunction::operator()(const std::vector<Expansion>& variables) const {
  std::vector<Expansion> values;
  values.reserve(steps_.size());
  for (std::size_t i = 0; i < steps_.size(); ++i) {
    const Step& step = steps_[i];
    const auto operand = [&](std::size_t k) -> const Expansion& {
      return values[step.operands[k]];
    };
    Expansion result;
    switch (step.kind) {
      case Kind::sum:
        for (std::size_t k = 0; k < step.operands.size(); ++k) result = sum(result, operand(k));
        break;
      case Kind::product:
        result.value = 1;
        for (std::size_t k = 0; k < step.operands.size(); ++k)
          result = product(result, operand(k));
        break;
      case Kind::power:
        result = power(operand(0), step.exponent);
        break;
      case Kind::inverse:
        result = power(operand(0), -1);
        break;
      case Kind::root:
        result = power(operand(0), 1.0 / step.exponent);
        break;
      case Kind::applied:
        result = applied(step.name, operand(0));
        break;
      default:
        if (variable_of_step_[i] < 0)
          result.value = step.constant;
        else
          result = variables[variable_of_step_[i]];
    }
    values.push_back(result);
  }
  return values.back();
}

}  // namespace seam::draw
