// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "symbolic/expand.h"
#include "symbolic/formula.h"
#include "symbolic/numbers.h"

namespace seam::symbolic {

/// The coefficients of a formula with respect to some of its variables: exponents (in the order
/// of `variables`) to the coefficient in the other symbols, in normal form; those that are 0
/// are left out. Roots and inverses of functions count among the other symbols; they hold
/// none of the variables, else `FormulaLimit` is thrown. Cost: that of multiplying the formula
/// out with FLINT.
using Coefficients = std::map<std::vector<int>, Formula>;
Coefficients coefficients(const Formula&, const std::vector<std::string>& variables,
                          const Numbers&);

/// What a formula is the sum of, in normal form; likewise with roots and inverses of functions.
/// Empty: it is 0.
std::vector<Monomial> monomials(const Formula&, const Numbers&);

/// Whether the normal form is 0; so the formula is, wherever it has a value. (One that holds
/// roots or inverses may be 0 all the same.)
bool vanishes(const Formula&, const Numbers&);

}  // namespace seam::symbolic
