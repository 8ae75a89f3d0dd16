// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include "check/region.h"

namespace seam::check {

/// Returns only if the steps prove `formula relation 0` on the region; throws `Open` if
/// they do not. Requires that formula and conditions hold no variables but the region's.
void verify(Context&, const Region&, const Polynomial& formula, certificate::Relation,
            const certificate::Subdivision&);

}  // namespace seam::check
