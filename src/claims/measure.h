// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "certificate/statement.h"
#include "symbolic/proposition.h"

namespace seam::claims {

/// What is measured of a sign; of all else nothing.
symbolic::Measure measure_of(const symbolic::Atom&);

/// Whether a formula is a polynomial in nothing but numbers, variables and functions that stand
/// in the statement.
bool speaks_of(const certificate::Statement&, const symbolic::Formula&);

}  // namespace seam::claims
