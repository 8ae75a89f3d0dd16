// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gmpxx.h>

namespace seam::exact {

/// An exact rational number, always in lowest terms (`canonicalize` after building from parts).
using Rational = mpq_class;
using Integer = mpz_class;

enum class Sign { negative = -1, zero = 0, positive = 1 };

}  // namespace seam::exact
