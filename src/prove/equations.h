// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "prove/region.h"

namespace seam::prove {

/// A system of equations, all in one ring: the parameters and bounded unknowns (the variables
/// of the factors), then the unbounded unknowns.
struct Equations {
  Factors factors;
  std::vector<std::string> unbounded;
  std::vector<int> unknowns;  ///< their places in the ring
  std::vector<const certificate::Function*> functions;
  std::vector<exact::Polynomial> radicands;  ///< of the functions
  std::vector<exact::Polynomial> system;
  std::vector<Condition> conditions;
  std::vector<std::vector<exact::Polynomial>> solutions;  ///< denominator * x - numerator

  /// The place of the first function in the ring.
  int first_function() const;
  bool holds_function(const exact::Polynomial&) const;
  /// No function in the degree of its root or above.
  exact::Polynomial reduced(exact::Polynomial) const;
};

}  // namespace seam::prove
