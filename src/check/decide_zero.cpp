// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "check/point.h"
#include "check/rules.h"

// A polynomial in variables is 0 exactly when each of its coefficients, a number, is; it
// is not 0 if one of them is certainly not, or if its value at some point is. With functions,
// which are not independent of the variables, only the value at a point tells.

namespace seam::check {

bool decide(Context& context, const certificate::Zero& zero, const certificate::Proof& proof) {
  const Polynomial formula = context.value(zero.formula);
  const std::set<int> functions = context.functions({zero.formula});
  if (const auto* witness = std::get_if<certificate::Witness>(&proof)) {
    const Point point = read_point(context, witness->point);
    demand_inside(context, {}, functions, point);
    demand(context.tower().sign(value_at(context, formula, point)) != 0,
           "the formula is 0 at the witness");
    return false;
  }
  demand(std::holds_alternative<certificate::Computation>(proof),
         "evidence of a kind that says nothing of an identity");
  bool all_zero = true, all_seen = true;
  for (const auto& [monomial, coefficient] :
       by_monomial(formula, context.tower().size(), context.meter())) {
    const auto sign = context.tower().find_sign(coefficient);
    if (sign && *sign != 0 && functions.empty()) return false;
    all_zero = all_zero && sign == 0;
    all_seen = all_seen && sign.has_value();
  }
  demand(all_seen, "effort: the normal form is not 0, nor seen to be different from 0");
  demand(all_zero, "the normal form is not 0, nor seen to be different from 0");
  return true;
}

}  // namespace seam::check
