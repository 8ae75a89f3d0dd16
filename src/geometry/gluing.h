// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/contact.h"

namespace seam::geometry {

/// closed, with this Euler characteristic.
Proposition closed(const Surface&, int euler, const Numbers&);

}  // namespace seam::geometry
