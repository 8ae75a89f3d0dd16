// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "claims/evaluate.h"

// Search only. Where an extremum seems to be attained: what rests on it is stated by whoever
// asks.
namespace seam::claims {

/// A point of a part of an extremum, and the value there.
struct Attained {
  std::size_t part = 0;  ///< its index
  std::map<std::string, Formula> point;
  Scalar here;    ///< the value there, as substituted
  Formula value;  ///< its normal form
};

/// Exact points with the best value found, at most so many, in the order of their coordinates;
/// the tower may grow by what they need. Throws `Unsupported` where there are none.
std::vector<Attained> attained(Evaluator&, const Extremum&, std::size_t most);

/// A point whose value differs from the extremum by about 2^-bits at most. Of functions with
/// roots: the best of a few points.
Attained nearly_attained(Evaluator&, const Extremum&, long bits);

/// About the largest (least) value.
double about(Evaluator&, const Extremum&);

/// Whether, at a place where the extremum seems to be attained, a mixed derivative in the
/// directions of two factors of a domain is not 0. False where a parameter occurs, or a root.
bool is_oblique(Evaluator&, const Extremum&);

}  // namespace seam::claims
