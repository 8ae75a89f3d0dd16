// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/identity.h"

#include <algorithm>
#include <set>

#include "geometry/normal_form.h"
#include "symbolic/coefficients.h"

namespace seam::geometry {
namespace {

bool has_no_root(const Formula& f, std::set<const void*>& seen) {
  if (f.kind() == Formula::Kind::root) return false;
  if (f.is_polynomial() || !seen.insert(f.identity()).second) return true;
  return std::ranges::all_of(
      f.operands(), [&](const Formula& operand) { return has_no_root(operand, seen); });
}

}  // namespace

bool is_nonzero_number(const Formula& f, const Numbers& numbers) {
  if (!f.is_polynomial()) return false;
  if (is_number(f)) return !is_zero(f, numbers);
  const auto names = variables(f);
  const auto found = coefficients(f, {names.begin(), names.end()}, numbers);
  return found.size() == 1 &&
         std::ranges::all_of(found.begin()->first, [](int exponent) { return exponent == 0; });
}

bool is_rational_function(const Formula& f) {
  std::set<const void*> seen;
  return has_no_root(f, seen);
}

}  // namespace seam::geometry
