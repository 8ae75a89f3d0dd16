// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include "certificate/statement.h"
#include "check/interval.h"

namespace seam::check {

/// Holds all values of the function on x, both in units of 2^-bits; of pi, whatever x is.
/// Throws `Open` where x is too large (or, of log, too close to 0) to be worked with, and for a
/// log unless all of x is > 0.
Interval elementary(certificate::Elementary function, const Interval& x, int bits, Meter&);

}  // namespace seam::check
