// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "symbolic/proposition.h"

namespace seam::claims {

/// All of some statements, and nothing else.
bool is_conjunction(const symbolic::Proposition&);

}  // namespace seam::claims
