// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "exact/polynomial.h"

namespace seam::exact {

/// number * product of factors^exponents; no factor is a number.
struct Factors {
  Polynomial number;
  std::vector<std::pair<Polynomial, int>> factors;
};

/// Over the rationals the factors are irreducible; over a tower some may still be products.
/// Requires f != 0.
Factors factors(const Polynomial& f);

}  // namespace seam::exact
