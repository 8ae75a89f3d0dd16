// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "exact/rational.h"

// Search only.
namespace seam::claims {

/// A function that seems to be >= a bound, or its negative, from where the last stretch ended
/// up to `end`.
struct Stretch {
  std::size_t function = 0;
  bool negative = false;
  std::optional<exact::Rational> end;  ///< none: to the end of all
};

/// Stretches one after the other that lead from one number to another, larger or smaller or
/// infinite. Few; none where none were found.
std::vector<Stretch> cover(const std::vector<std::function<double(double)>>& functions,
                           double bound, double from, double to);

}  // namespace seam::claims
