// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "symbolic/formula.h"
#include "symbolic/numbers.h"

// What can be said of a formula for all values of its variables, by multiplying it out; beside
// `symbolic::vanishes`. Search only: whoever rests on an identity states it.
namespace seam::geometry {

using symbolic::Formula;
using symbolic::Numbers;

/// f is one and the same number for all values, and not 0. False may mean unknown.
bool is_nonzero_number(const Formula&, const Numbers&);

}  // namespace seam::geometry
