// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "certificate/statement.h"
#include "exact/rational.h"

namespace seam::prove {

/// What is `unknown` of the slack where nothing at all is said: certain, too.
inline constexpr const char* no_point = "no point of the domain meets its conditions";

/// A formula, and what it was multiplied by: a term of the statement, or none (-1). It is > 0
/// where the obligation speaks.
struct Measured {
  int obligation = 0;
  certificate::Term scale = -1;
};

/// How far f / scale stays from 0, on the side where `f relation 0` holds: the least value of
/// |f / scale| over the domain lies in [low, high].
struct Slack {
  struct Coordinate {
    std::string variable;
    exact::Rational low, high;  ///< the same where it is rational
  };
  exact::Rational low;
  std::optional<exact::Rational> high;  ///< none: no point of the domain was looked at
  std::vector<Coordinate> at;           ///< a point where the value is `high` at most
  std::string unknown;                  ///< why nothing is known; then the rest says nothing
};

/// The slack of sign obligations that hold, one for each; of those that are no inequalities it
/// is looked at only whether there is a point that they speak of. Certain, if they do hold. The
/// same for the same input; takes a bounded number of steps beyond the expansion of the
/// formulas.
std::vector<Slack> slacks(const certificate::Statement&, const std::vector<Measured>&);

}  // namespace seam::prove
