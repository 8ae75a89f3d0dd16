// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include <set>
#include <string>
#include <vector>

#include "check/context.h"

namespace seam::check {

/// F1, F2, ...: the coefficients of the formulas with respect to the variables `for_all`, in
/// the order that `certificate::Roots` lays down. At a point all of them are 0 exactly when
/// every formula is, for all real values of these variables. Throws `Open` if a formula
/// holds a variable that is neither one of these nor one of `others`.
std::vector<Polynomial> read_system(Context&, const std::vector<certificate::Term>& formulas,
                                    const std::vector<std::string>& for_all,
                                    const std::set<int>& others);

}  // namespace seam::check
