// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "exact/field.h"

namespace seam::prove {

/// The weights w with sum w_j corners[j] = point, for as many corners as coordinates. Doubles:
/// empty if singular.
std::vector<double> barycentric(const std::vector<std::vector<double>>& corners,
                                const std::vector<double>& point);
/// Requires independent corners.
std::vector<exact::Polynomial> barycentric(
    const std::vector<std::vector<exact::Polynomial>>& corners,
    const std::vector<exact::Polynomial>& point);

}  // namespace seam::prove
