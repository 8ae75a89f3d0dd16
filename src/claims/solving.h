// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "claims/stating.h"

namespace seam::claims {

/// A "solve" that has been read: its unknowns as symbols, its system as equations F = 0.
struct Solving {
  Stating& stating;
  const Expression& at;
  Context around;                       ///< the quantifiers around it
  Scope scope;                          ///< with the unknowns
  std::vector<std::string> unknowns;    ///< their symbols
  std::vector<const Expression*> sets;  ///< one an unknown; null: every real number
  std::vector<const Expression*> conditions;
  std::vector<std::string> for_all;  ///< the F vanish for all real values of these
  std::vector<Formula> equations;

  Evaluator& evaluator() const { return stating.evaluator; }
  const std::vector<Expression>& solutions() const { return at.children[3].children; }
};

/// One unknown, and no number but algebraic ones. Nothing if it is of another kind.
std::optional<Proposition> solved_alone(const Solving&);

/// Any unknowns; system and solutions may hold parameters.
Proposition solved_together(const Solving&);

}  // namespace seam::claims
