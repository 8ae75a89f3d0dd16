// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "symbolic/formula.h"
#include "symbolic/numbers.h"

namespace seam::symbolic {

/// The coefficients of a formula with respect to some of its variables: exponents (in the order
/// of `variables`) to the coefficient in the other symbols, in normal form; those that are 0
/// are left out. Cost: that of multiplying the formula out with FLINT.
using Coefficients = std::map<std::vector<int>, Formula>;
Coefficients coefficients(const Formula&, const std::vector<std::string>& variables,
                          const Numbers&);

}  // namespace seam::symbolic
