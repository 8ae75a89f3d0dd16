// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "exact/polynomial.h"

namespace seam::exact {

/// f = root^2 * cofactor with a root that is no number.
struct SquareFactor {
  Polynomial root, cofactor;
};

/// Found if f is a number times a polynomial with rational coefficients.
std::optional<SquareFactor> square_factor(const Polynomial& f);

}  // namespace seam::exact
