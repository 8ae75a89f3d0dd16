// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "symbolic/numbers.h"

namespace seam::draw {

/// The value of a function and its derivatives in two parameters, to the second order.
struct Expansion {
  double value = 0, u = 0, v = 0, uu = 0, uv = 0, vv = 0;
};

/// A formula as a list of operations on doubles: for drawings alone.
class RoundedFunction {
 public:
  /// In these variables; others have no value (NaN).
  RoundedFunction(const symbolic::Formula&, const std::vector<std::string>& variables,
                  const symbolic::Numbers&);

  /// What the variables are, in order; not a number (NaN) where there is no value.
  Expansion operator()(const std::vector<Expansion>& variables) const;

 private:
  struct Step {
    symbolic::Formula::Kind kind;
    double constant = 0;
    int exponent = 0;
    std::string name;
    std::vector<int> operands;  ///< numbers of earlier steps
  };
  std::vector<Step> steps_;
  std::vector<int> variable_of_step_;  ///< -1: a constant
};

}  // namespace seam::draw
