// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "exact/polynomial.h"

namespace seam::bernstein {

/// Search only: the critical point of numerator / denominator near `start`, to about `bits`
/// bits, in all variables of their ring; nothing if Newton's method does not settle.
std::optional<std::vector<exact::Rational>> refined(const exact::Polynomial& numerator,
                                                    const exact::Polynomial& denominator,
                                                    const std::vector<double>& start,
                                                    long bits);

}  // namespace seam::bernstein
