// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "exact/rational.h"

namespace seam::prove {

/// Some x >= 0 with sum rows[i][j] x_j <= bounds[i] for all i at which the last x is greatest,
/// or, after many steps, great; nothing if none was found.
std::optional<std::vector<exact::Rational>> linear_program(
    std::vector<std::vector<exact::Rational>> rows, std::vector<exact::Rational> bounds);

}  // namespace seam::prove
