// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "claims/state.h"
#include "symbolic/proposition.h"

namespace seam::claims {

/// The statement for every value of an integer parameter that has none yet.
Stated for_every_integer(Evaluator&, const Expression& statement, const Scope&,
                         const std::string& parameter);

/// The statement for all values of the parameters it holds, where the constraints hold.
Stated stated_under(Evaluator&, const Expression& statement, const Scope&,
                    const std::vector<symbolic::Constraint>&);

}  // namespace seam::claims
