// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>

#include "check/judge.h"
#include "claims/export.h"
#include "cli/formulas.h"
#include "cli/outcome.h"

namespace seam::cli {

/// What refutes, in a line: the point of the first obligation that fails by one, and the
/// relation that holds there instead; a solution that is wrong or missing; what was counted.
std::string witness_of(const certificate::Statement&, const certificate::Evidence&,
                       const check::Judgement&, const claims::Exported&, Formulas&,
                       const NormalForm&);

/// The obligations that stand under an odd number of negations and nowhere else: the claim
/// gains where they fail.
std::set<int> only_denied(const certificate::Statement&);

}  // namespace seam::cli
