// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/identity.h"
#include "geometry/surface.h"

namespace seam::geometry {

/// The pairs of a side of one patch with a side of another that are one curve, in one direction
/// or the other, whatever the values of the variables in their control points.
struct SidePairs {
  std::vector<Seam> always;
  bool sometimes = false;  ///< others may be one curve for some of the values
};
SidePairs side_pairs(const Patch&, const Patch&, const Numbers&, const Vanishing&);

}  // namespace seam::geometry
