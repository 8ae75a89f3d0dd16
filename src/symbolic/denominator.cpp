// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/denominator.h"

#include <algorithm>

// Printed formulas have denominators such as 3*(4 - 3*c^2) and (1 - c^2)*(4 - 3*c^2): products
// of few factors that come back as they were written. To compare factors as trees costs next to
// nothing and keeps degrees low; nothing rests on finding all common factors.

namespace seam::symbolic {
namespace {

using Kind = Formula::Kind;

void collect(const Formula& f, int exponent, Factors& into) {
  if (f.is_constant()) {
    into.constant *= power(f, exponent).value();
  } else if (f.kind() == Kind::product) {
    for (const Formula& factor : f.operands()) collect(factor, exponent, into);
  } else if (f.kind() == Kind::power) {
    collect(f.operands()[0], exponent * f.exponent(), into);
  } else {
    const auto same =
        std::ranges::find_if(into.powers, [&](const auto& p) { return p.first.same(f); });
    if (same == into.powers.end())
      into.powers.emplace_back(f, exponent);
    else
      same->second += exponent;
  }
}

int exponent_in(const Factors& factors, const Formula& f) {
  for (const auto& [factor, exponent] : factors.powers)
    if (factor.same(f)) return exponent;
  return 0;
}

}  // namespace

Factors factors(const Formula& f) {
  Factors result;
  collect(f, 1, result);
  return result;
}

Formula product(const Factors& all) {
  std::vector<Formula> result = {Formula(all.constant)};
  for (const auto& [factor, exponent] : all.powers) result.push_back(power(factor, exponent));
  return symbolic::product(std::move(result));
}

Formula merged_product(const Formula& a, const Formula& b) {
  if (a.is(1)) return b;
  if (b.is(1)) return a;
  Factors all = factors(a);
  collect(b, 1, all);
  return product(all);
}

Common common_denominator(const Formula& a, const Formula& b) {
  if (a.same(b)) return {a, 1, 1};
  if (a.is(1)) return {b, b, 1};
  if (b.is(1)) return {a, 1, a};
  const Factors left = factors(a), right = factors(b);
  Factors beside_a{right.constant, {}}, beside_b{left.constant, {}};
  for (const auto& [factor, exponent] : right.powers)
    if (const int more = exponent - exponent_in(left, factor); more > 0)
      beside_a.powers.emplace_back(factor, more);
  for (const auto& [factor, exponent] : left.powers)
    if (const int more = exponent - exponent_in(right, factor); more > 0)
      beside_b.powers.emplace_back(factor, more);
  const Formula multiple = product(beside_a);
  return {merged_product(a, multiple), multiple, product(beside_b)};
}

}  // namespace seam::symbolic
