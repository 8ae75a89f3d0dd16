// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "symbolic/numbers.h"

namespace seam::symbolic {

/// About the value of a formula where its variables have these values; not a number (NaN) where
/// it has none. For guesses: nothing may rest on it.
double approximate(const Formula&, const std::map<std::string, double>& point, const Numbers&);

}  // namespace seam::symbolic
