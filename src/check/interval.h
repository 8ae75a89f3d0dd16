// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include "check/polynomial.h"

namespace seam::check {

/// The closed interval [low, high] / 2^bits; the number of bits is known from the
/// context and the same for both operands. Every result holds all values of the
/// operation on values of the operands.
struct Interval {
  Integer low, high;

  bool holds_zero() const { return low <= 0 && high >= 0; }
  Integer width() const { return high - low; }
};

/// The largest integer <= a / b, and the smallest >= a / b. Require b > 0.
Integer floor_quotient(const Integer& a, const Integer& b);
Integer ceiling_quotient(const Integer& a, const Integer& b);

Interval sum(const Interval& a, const Interval& b);
Interval scaled(const Interval& a, const Integer& factor);
Interval product(const Interval& a, const Interval& b, int bits);
/// Requires that b does not hold zero.
Interval quotient(const Interval& a, const Interval& b, int bits);
/// The same set, or a little more, at another number of bits.
Interval rescaled(const Interval& a, int from_bits, int to_bits);

}  // namespace seam::check
