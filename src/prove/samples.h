// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "prove/subdivide.h"

namespace seam::prove {

/// A point of a domain and, in doubles, the values there of variables and functions.
struct Sample {
  Place place;  ///< in the factors of the domain
  std::vector<double> values;
};

/// Points of a region, simple ones first; nearly so, where a condition is an equation. No place
/// of weight 0, none on an open facet.
std::vector<Sample> samples(Workshop&, const Region&);

/// The point with the values of the functions there, if it is one of the region at which
/// `f relation 0` fails, exactly. The tower may grow, if `may_adjoin`.
std::optional<certificate::Point> witness(Workshop&, const Region&, const exact::Polynomial& f,
                                          certificate::Relation, const Place&, bool may_adjoin);

}  // namespace seam::prove
