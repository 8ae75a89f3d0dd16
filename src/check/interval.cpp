// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "check/interval.h"

#include <algorithm>
#include <array>

// A product is linear in each operand, so its extremes lie at ends of both. A quotient by
// positive numbers is least for the least numerator, over the least denominator if
// that numerator is negative, else over the greatest. Every rounding is outward.

namespace seam::check {
namespace {

// The largest integer <= a / 2^bits.
Integer floor_shift(const Integer& a, int bits) {
  if (a >= 0) return a >> bits;
  return -((-a + (Integer(1) << bits) - 1) >> bits);
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
  const std::array ends = {a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high};
  const auto [least, greatest] = std::ranges::minmax_element(ends);
  return {floor_shift(*least, bits), -floor_shift(-*greatest, bits)};
}

Interval quotient(const Interval& a, const Interval& b, int bits) {
  if (b.high < 0) return quotient(scaled(a, -1), scaled(b, -1), bits);
  const Integer low = a.low << bits;
  const Integer high = a.high << bits;
  return {floor_quotient(low, low < 0 ? b.low : b.high),
          ceiling_quotient(high, high < 0 ? b.high : b.low)};
}

Interval rescaled(const Interval& a, int from_bits, int to_bits) {
  if (to_bits >= from_bits)
    return {a.low << (to_bits - from_bits), a.high << (to_bits - from_bits)};
  return {floor_shift(a.low, from_bits - to_bits), -floor_shift(-a.high, from_bits - to_bits)};
}

}  // namespace seam::check
