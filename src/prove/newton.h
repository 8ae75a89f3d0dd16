// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "bernstein/critical.h"

namespace seam::prove {

/// The inverse of the Jacobian of as many equations as variables at a point, in doubles; empty
/// if it is nearly singular.
std::vector<std::vector<double>> inverse_jacobian(const std::vector<bernstein::Sketch>&,
                                                  const std::vector<double>& point);

/// Where Newton's method leads from a point; empty if nowhere.
std::vector<double> newton(const std::vector<bernstein::Sketch>&, std::vector<double> from);

}  // namespace seam::prove
