// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/surface.h"
#include "symbolic/proposition.h"

namespace seam::geometry {

/// Round a closed corner of a surface that is G1 along its seams: the sectors follow one
/// another round the common normal, in one sense, exactly once. Requires a closed corner.
symbolic::Proposition winds_once(const Surface&, const Corner&);

}  // namespace seam::geometry
