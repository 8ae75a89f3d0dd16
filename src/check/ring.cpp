// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "check/ring.h"

#include <utility>

// The rule of a symbol g says  g^n = row 0, of lower degree in g. Rewriting by it
// brings in earlier symbols only, so one pass from the last rule to the first ends
// in normal form. A row of one rule calls upon earlier rules alone: the recursion is
// no deeper than the number of rules.

namespace seam::check {

void Ring::add_rule(int index, const Polynomial& polynomial) {
  auto parts = by_exponent(polynomial, index, *meter_);
  if (parts.empty() || parts.rbegin()->first == 0) return;
  const auto [top, leading] = *parts.rbegin();
  if (!leading.is_rational()) return;
  const Integer numerator = leading.terms.begin()->second;
  const Polynomial factor = numerator > 0 ? constant(-leading.denominator, numerator)
                                          : constant(leading.denominator, -numerator);
  parts.erase(top);
  Polynomial tail;
  for (const auto& [e, part] : parts)
    add(tail, multiply(part, power(symbol(index), e), *meter_), *meter_);
  Polynomial first = reduce(multiply(tail, factor, *meter_));
  rules_.push_back({index, top, {std::move(first)}});
}

const Polynomial& Ring::row(Rule& rule, int e) {
  const auto wanted = static_cast<std::size_t>(e - rule.degree);
  if (wanted < rule.rows.size()) return rule.rows[wanted];
  std::size_t held = 0;
  for (const Polynomial& known : rule.rows) held += words(known);
  while (rule.rows.size() <= wanted) {
    Polynomial next = reduce(multiply(rule.rows.back(), symbol(rule.index), *meter_));
    demand((held += words(next)) <= Meter::max_words, "effort");
    rule.rows.push_back(std::move(next));
  }
  return rule.rows[wanted];
}

Polynomial Ring::reduce(Polynomial p) {
  for (std::size_t i = rules_.size(); i-- > 0;) {
    Rule& rule = rules_[i];
    meter_->charge(p.terms.size());
    if (degree(p, rule.index) < rule.degree) continue;
    Polynomial result;
    for (const auto& [e, part] : by_exponent(p, rule.index, *meter_)) {
      if (e >= rule.degree)
        add(result, multiply(part, row(rule, e), *meter_), *meter_);
      else if (e > 0)
        add(result, multiply(part, power(symbol(rule.index), e), *meter_), *meter_);
      else
        add(result, part, *meter_);
    }
    p = std::move(result);
  }
  return p;
}

Polynomial Ring::sum(Polynomial a, const Polynomial& b) {
  add(a, b, *meter_);
  return a;
}

Polynomial Ring::difference(Polynomial a, const Polynomial& b) {
  add(a, negated(b), *meter_);
  return a;
}

Polynomial Ring::product(const Polynomial& a, const Polynomial& b) {
  return reduce(multiply(a, b, *meter_));
}

Polynomial Ring::power(Polynomial base, int n) {
  Polynomial result = constant(1);
  for (;; n /= 2) {
    if (n % 2 == 1) result = product(result, base);
    if (n <= 1) return result;
    base = product(base, base);
  }
}

Polynomial Ring::substitute(const Polynomial& p, int index, const Polynomial& value) {
  Polynomial result;
  Polynomial value_power = constant(1);
  int reached = 0;
  for (const auto& [e, part] : by_exponent(p, index, *meter_)) {
    if (e > reached) value_power = product(value_power, power(value, e - reached));
    reached = e;
    add(result, product(part, value_power), *meter_);
  }
  return result;
}

}  // namespace seam::check
