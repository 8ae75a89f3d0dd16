// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "claims/stating.h"

namespace seam::claims {

/// Where a condition a < b or a <= b stands between two variables of one and the same bounded
/// interval: they range over a triangle instead, and the condition is gone. The set stays the
/// same.
void order_to_triangle(Context&, const Numbers&);

}  // namespace seam::claims
