// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "check/interval.h"

#include <algorithm>
#include <array>

// Products and quotients are monotone in each operand on either side of zero, so
// their extremes lie at ends of the operands. Every rounding is outward.

namespace seam::check {
namespace {

Interval rounded(const std::array<Integer, 4>& numerators,
                 const std::array<Integer, 4>& denominators) {
  Interval hull{floor_quotient(numerators[0], denominators[0]),
                ceiling_quotient(numerators[0], denominators[0])};
  for (std::size_t i = 1; i < numerators.size(); ++i) {
    hull.low = std::min(hull.low, floor_quotient(numerators[i], denominators[i]));
    hull.high = std::max(hull.high, ceiling_quotient(numerators[i], denominators[i]));
  }
  return hull;
}

}  // namespace

// Integer division truncates towards zero.
Integer floor_quotient(const Integer& a, const Integer& b) {
  Integer result = a / b;
  if (result * b > a) --result;
  return result;
}

Integer ceiling_quotient(const Integer& a, const Integer& b) {
  return -floor_quotient(-a, b);
}

Interval sum(const Interval& a, const Interval& b) {
  return {a.low + b.low, a.high + b.high};
}

Interval scaled(const Interval& a, const Integer& factor) {
  if (factor < 0) return {a.high * factor, a.low * factor};
  return {a.low * factor, a.high * factor};
}

Interval product(const Interval& a, const Interval& b, int bits) {
  const Integer unit = Integer(1) << bits;
  return rounded({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high},
                 {unit, unit, unit, unit});
}

Interval quotient(const Interval& a, const Interval& b, int bits) {
  if (b.high < 0) return quotient(scaled(a, -1), scaled(b, -1), bits);
  const Interval up{a.low << bits, a.high << bits};
  return rounded({up.low, up.low, up.high, up.high}, {b.low, b.high, b.low, b.high});
}

Interval rescaled(const Interval& a, int from_bits, int to_bits) {
  if (to_bits >= from_bits)
    return {a.low << (to_bits - from_bits), a.high << (to_bits - from_bits)};
  const Integer unit = Integer(1) << (from_bits - to_bits);
  return {floor_quotient(a.low, unit), ceiling_quotient(a.high, unit)};
}

}  // namespace seam::check
