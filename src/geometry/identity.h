// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "symbolic/formula.h"
#include "symbolic/numbers.h"

// What can be said of a formula for all values of its variables. Search only: whoever rests on
// an identity states it.
namespace seam::geometry {

using symbolic::Formula;
using symbolic::Numbers;

/// Whether f is 0 wherever it has a value. False may mean unknown, but not of a rational
/// function.
using Vanishing = std::function<bool(const Formula&)>;

/// f is one and the same number for all values, and not 0. False may mean unknown.
bool is_nonzero_number(const Formula&, const Numbers&);

/// A quotient of polynomials in its variables, as it is written.
bool is_rational_function(const Formula&);

}  // namespace seam::geometry
