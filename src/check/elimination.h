// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include <vector>

#include "check/context.h"
#include "check/region.h"

namespace seam::check {

/// A `certificate::OnlySolutions` in polynomials.
struct SystemOfEquations {
  std::vector<Polynomial> equations;
  Region domain;               ///< its conditions may hold `unbounded`
  std::set<int> functions;     ///< of the variables of the domain
  std::vector<int> unbounded;  ///< the unknowns that belong to no factor
  std::set<int> variables;     ///< of the factors, the unknowns, and the functions
  /// denominator * x - numerator, by solution and unknown.
  std::vector<std::vector<Polynomial>> solutions;
};

/// Returns only if the steps prove that there is no solution but those; else throws `Open`.
void verify(Context&, const SystemOfEquations&, const certificate::Elimination&);

}  // namespace seam::check
