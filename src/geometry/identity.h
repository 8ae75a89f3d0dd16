// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "symbolic/formula.h"
#include "symbolic/numbers.h"

// What can be said of a formula for all values of its variables, by multiplying it out. Search
// only: whoever rests on an identity states it.
namespace seam::geometry {

using symbolic::Formula;
using symbolic::Numbers;

/// f is 0 for all values. Of a polynomial false means that it is not, else it may mean unknown.
bool vanishes_identically(const Formula&, const Numbers&);

/// f is one and the same number for all values, and not 0. False may mean unknown.
bool is_nonzero_number(const Formula&, const Numbers&);

/// A polynomial in its variables, as it is written.
bool is_polynomial(const Formula&);

}  // namespace seam::geometry
