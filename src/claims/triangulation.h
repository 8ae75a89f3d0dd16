// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "symbolic/proposition.h"

namespace seam::claims {

/// Closed simplices, each in all the variables, that together are the product of the factors,
/// which are closed and bounded.
std::vector<symbolic::Simplex> triangulated(const std::vector<symbolic::Simplex>& factors);

}  // namespace seam::claims
