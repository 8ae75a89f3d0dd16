// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>
#include <vector>

#include "coq/draft.h"

namespace seam::coq {

/// `Positive`, as the library calls the relation.
const char* relation_code(certificate::Relation);
/// `formula > 0`.
std::string relation_text(const Written&, certificate::Relation);

/// The domain of a draft: what was said of it.
struct Stated {
  std::vector<Factor> factors;
  std::vector<std::vector<Inequality>> inequalities;  ///< one list a factor
  std::vector<std::string> variables;   ///< named: those of factors, then those of none
  std::vector<std::string> conditions;  ///< named: that they hold
};

/// Gives places to the variables, those of factors first.
Stated place_domain(Draft&, const certificate::Sign&, const std::set<std::string>& variables,
                    bool with_coordinates);

/// `forall u : R, 0 <= u -> ...`, values with names, conditions, and the relation.
void say_for_all(Draft&, Stated&, const certificate::Sign&);

/// The conditions, as the library is given them.
std::string condition_codes(const Draft&, const certificate::Sign&);

}  // namespace seam::coq
