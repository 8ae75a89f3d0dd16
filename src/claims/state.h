// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "claims/evaluate.h"

namespace seam::claims {

/// What a statement says, in propositions about formulas.
///
/// `goal` is the statement itself; `guards` say that its formulas mean something (no divisor
/// vanishes where the statement looks) and that what was worked out on the way is right (a
/// count, an extremum).
struct Stated {
  symbolic::Proposition goal;
  std::vector<symbolic::Proposition> guards;
  std::set<std::string> predicates;  ///< names of those used
};

/// Throws `Problem` for a wrong text, `Unsupported` for a kind of statement without a proof
/// method, `Broken`.
Stated state(Evaluator&, const Expression& statement, const Scope&);

}  // namespace seam::claims
