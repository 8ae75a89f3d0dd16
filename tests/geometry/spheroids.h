// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/surface.h"

// The four surfaces of Peters and Kobbelt, The Platonic Spheroids: closed, G2.
namespace seam::geometry::testing {

using symbolic::Numbers;

Patch tetroid_patch();
Patch hexoid_patch();
Patch octoid_patch();
Patch icosoid_patch(Numbers&);

Surface tetroid(Numbers&);
Surface hexoid(Numbers&);
Surface octoid(Numbers&);
Surface icosoid(Numbers&);

}  // namespace seam::geometry::testing
