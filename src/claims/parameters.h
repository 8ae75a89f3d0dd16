// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>

#include "claims/stating.h"

namespace seam::claims {

/// The parameters of the file among the variables join the context, with their sets and
/// conditions, and those that the conditions hold; they join the variables too.
void join_parameters(const Evaluator&, std::set<std::string>& variables, Context&);

bool meets(exact::Sign, Relation);  ///< whether a number with this sign does

/// Whether some values of these parameters are found that meet their conditions.
bool is_inhabited(Evaluator&, const std::set<std::string>& parameters);

}  // namespace seam::claims
