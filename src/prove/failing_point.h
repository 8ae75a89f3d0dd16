// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "prove/region.h"

namespace seam::prove {

/// A point of the factors, and of the real line for each other variable, at which the
/// conditions hold and `f relation 0` does not, exactly; if a simple one is found. The
/// polynomials are in all these variables, those of the factors first. No new numbers are made.
std::optional<certificate::Point> failing_point(Workshop&, const Factors&,
                                                const std::vector<Condition>& where,
                                                const exact::Polynomial& f,
                                                certificate::Relation);

}  // namespace seam::prove
