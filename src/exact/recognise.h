// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "exact/field.h"

namespace seam::exact {

/// Search only: a number over the tower, with small coordinates, that is close to `value`,
/// which is right to about `bits` bits. Lattice reduction.
std::optional<Polynomial> recognise(const RingPtr& numbers, const Rational& value, long bits);

/// Search only: a polynomial with small integer coefficients, of the least degree up to `most`,
/// that nearly vanishes at `value`, which is right to about `bits` bits.
std::optional<Univariate> annihilator(const RingPtr& numbers, const Rational& value, int most,
                                      long bits);

/// value * 2^bits, of either sign.
Rational scaled(Rational value, long bits);
/// The value with this many bits after the point, rounded down.
Rational truncated(const Rational& value, long bits);

/// The fraction of least denominator within `tolerance` of the value. Stern-Brocot.
Rational simplest(const Rational& value, const Rational& tolerance);

}  // namespace seam::exact
