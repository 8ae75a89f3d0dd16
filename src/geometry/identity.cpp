// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/identity.h"

#include <algorithm>
#include <set>

#include "geometry/normal_form.h"
#include "symbolic/coefficients.h"

namespace seam::geometry {
namespace {

symbolic::Coefficients multiplied_out(const Formula& f, const Numbers& numbers) {
  const auto names = variables(f);
  return coefficients(f, {names.begin(), names.end()}, numbers);
}

bool is_polynomial(const Formula& f, std::set<const void*>& seen) {
  using Kind = Formula::Kind;
  const bool is_leaf =
      f.kind() == Kind::constant || f.kind() == Kind::symbol || f.kind() == Kind::known;
  if (is_leaf || !seen.insert(f.identity()).second) return true;
  if (f.kind() != Kind::sum && f.kind() != Kind::product && f.kind() != Kind::power)
    return false;
  return std::ranges::all_of(
      f.operands(), [&](const Formula& operand) { return is_polynomial(operand, seen); });
}

}  // namespace

bool vanishes_identically(const Formula& f, const Numbers& numbers) {
  return is_number(f) ? is_zero(f, numbers) : multiplied_out(f, numbers).empty();
}

bool is_nonzero_number(const Formula& f, const Numbers& numbers) {
  if (is_number(f)) return !is_zero(f, numbers);
  const auto found = multiplied_out(f, numbers);
  return found.size() == 1 &&
         std::ranges::all_of(found.begin()->first, [](int exponent) { return exponent == 0; });
}

bool is_polynomial(const Formula& f) {
  std::set<const void*> seen;
  return is_polynomial(f, seen);
}

}  // namespace seam::geometry
