// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/builtin.h"
#include "claims/elementary.h"
#include "claims/limit.h"

namespace seam::claims {
namespace {

// Of a number or function; on a patch, point by point.
Value applied(const Call& call, const char* function) {
  const auto at = [&](const Scalar& x) {
    return elementary(function, x, call.evaluator.numbers);
  };
  const Value value = call.value(0);
  if (const auto* field = value.as<Field>(); field && field->components.size() == 1)
    return {Field{field->shape, {at(field->components[0])}}};
  return {at(as_scalar(call.evaluator, value, call[0]))};
}

Value exp(const Call& call) {
  return applied(call, "exp");
}
Value log(const Call& call) {
  return applied(call, "log");
}
Value sin(const Call& call) {
  return applied(call, "sin");
}
Value cos(const Call& call) {
  return applied(call, "cos");
}
Value tan(const Call& call) {
  return arithmetic(call.evaluator, call.at, "/", sin(call), cos(call));
}

}  // namespace

const Builtins& elementary_builtins() {
  static const Builtins table = {{"exp", {1, 1, exp}}, {"log", {1, 1, log}},
                                 {"sin", {1, 1, sin}}, {"cos", {1, 1, cos}},
                                 {"tan", {1, 1, tan}}, {"limit", {1, 1, limit}}};
  return table;
}

}  // namespace seam::claims
