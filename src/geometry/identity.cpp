// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/identity.h"

#include "geometry/normal_form.h"
#include "symbolic/coefficients.h"

namespace seam::geometry {

bool is_nonzero_number(const Formula& f, const Numbers& numbers) {
  if (!f.is_polynomial()) return false;
  if (is_number(f)) return !is_zero(f, numbers);
  const auto names = variables(f);
  const auto found = coefficients(f, {names.begin(), names.end()}, numbers);
  return found.size() == 1 &&
         found.begin()->first == std::vector<int>(names.size(), 0);
}

}  // namespace seam::geometry
