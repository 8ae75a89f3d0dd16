// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "claims/builtin.h"

namespace seam::claims {

/// limit(E for n -> infinity), of a number or a vector; `Unsupported` where it is not found or
/// there is none.
Value limit(const Call&);

}  // namespace seam::claims
