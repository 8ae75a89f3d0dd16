// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "check/elementary.h"

#include <algorithm>

// Every operation is one on intervals, so that only what is left out of a series has to be
// bounded. All of it works with so many bits more than are asked for that this hardly shows.
//
// exp, sin, cos. With y = x / 2^k, |y| <= 2^-16, what Taylor's series of order n leaves out is
// at most 2 |y|^n / n! <= 2^(1 - 16 n) (Lagrange). Then k times exp(2 y) = exp(y)^2, or
// sin(2 y) = 2 sin(y) cos(y) and cos(2 y) = 1 - 2 sin(y)^2.
//
// log. It increases: its values lie between those at the ends. x = 2^s m with 1/2 <= m <= 1, so
// z = (m - 1) / (m + 1) lies in [-1/3, 0], and log x = s log 2 + 2 artanh z, log 2 = 2 artanh
// 1/3. For |z| <= 1/2 the series z + z^3 / 3 + ... less its first n terms is at most
// |z|^(2 n + 1) / ((2 n + 1) (1 - z^2)) <= 4^-n.
//
// pi = 16 arctan(1/5) - 4 arctan(1/239) (Machin), z - z^3 / 3 + ..., with the same bound.

namespace seam::check {
namespace {

using certificate::Elementary;

constexpr int most_whole_bits = 14;  // |x| < 2^14
constexpr int small = 16;            // |y| <= 2^-16

int bit_length(const Integer& n) {
  return n == 0 ? 0 : static_cast<int>(boost::multiprecision::msb(n < 0 ? -n : n)) + 1;
}

class Series {
 public:
  Series(int bits, Meter& meter) : bits_(bits), meter_(meter) {}

  Interval whole(const Integer& n) const { return {n << bits_, n << bits_}; }

  Interval times(const Interval& a, const Interval& b) const {
    const std::size_t left = std::max(limbs(a.low), limbs(a.high));
    const std::size_t right = std::max(limbs(b.low), limbs(b.high));
    demand(64 * (left + right) <= Meter::max_bits, "effort");
    meter_.charge(4 * left * right);
    return product(a, b, bits_);
  }

  Interval over(const Interval& a, const Integer& n) const {
    meter_.charge(2 * limbs(a.high));
    return {floor_quotient(a.low, n), ceiling_quotient(a.high, n)};
  }

  static Interval widened(const Interval& a) { return {a.low - 1, a.high + 1}; }

  // 1 + z / d(1) (1 + z / d(2) (1 + ...)), with so many terms that one unit bounds what is left
  // out, for z = y or z = -y^2.
  template <typename Divisor>
  Interval taylor(const Interval& z, const Divisor& divisor) const {
    Interval result = whole(1);
    for (int n = bits_ / small + 2; n > 0; --n)
      result = sum(whole(1), over(times(z, result), divisor(n)));
    return widened(result);
  }

  // z + side z^3 / 3 + z^5 / 5 + ..., side = 1 or -1; |z| <= 1/2.
  Interval odd(const Interval& z, int side) const {
    const Interval half = over(whole(1), 2);
    demand(z.high <= half.high && -z.low <= half.high, "effort");
    const Interval square = scaled(times(z, z), side);
    Interval result = whole(0);
    for (int n = bits_ / 2 + 1; n >= 0; --n)
      result = sum(over(whole(1), 2 * n + 1), times(square, result));
    return widened(times(z, result));
  }

  Interval exp(const Interval& y, int doublings) const {
    Interval result = taylor(y, [](int n) { return n; });
    for (int k = 0; k < doublings; ++k) result = times(result, result);
    return result;
  }

  struct Turn {
    Interval cos, sin;
  };
  Turn turn(const Interval& y, int doublings) const {
    const Interval z = scaled(times(y, y), -1);
    Turn result{taylor(z, [](int n) { return (2 * n - 1) * (2 * n); }),
                times(y, taylor(z, [](int n) { return (2 * n) * (2 * n + 1); }))};
    for (int k = 0; k < doublings; ++k)
      result = {sum(whole(1), scaled(times(result.sin, result.sin), -2)),
                scaled(times(result.sin, result.cos), 2)};
    return result;
  }

  Interval pi() const {
    return sum(scaled(odd(over(whole(1), 5), -1), 16),
               scaled(odd(over(whole(1), 239), -1), -4));
  }

  // Of x / 2^bits > 0.
  Interval log(const Integer& x) const {
    const int shift = bit_length(x) - bits_;
    const Interval m = rescaled({x, x}, bits_ + shift, bits_);
    const Interval z = quotient(sum(m, whole(-1)), sum(m, whole(1)), bits_);
    const Interval log2 = scaled(odd(over(whole(1), 3), 1), 2);
    return sum(scaled(log2, shift), scaled(odd(z, 1), 2));
  }

 private:
  int bits_;
  Meter& meter_;
};

// No value lies outside [-1, 1].
Interval clamped(const Interval& x, const Integer& one) {
  return {std::max<Integer>(x.low, -one), std::min<Integer>(x.high, one)};
}

}  // namespace

Interval elementary(Elementary function, const Interval& x, int bits, Meter& meter) {
  const bool halves = function != Elementary::pi && function != Elementary::log;
  const int size = std::max(bit_length(x.low), bit_length(x.high)) - bits;
  const int whole = halves ? std::max(0, size) : 0;
  demand(whole <= most_whole_bits, "effort: a function of a large number");
  const int doublings = whole + small, working = bits + 3 * doublings + 16;
  const Series series(working, meter);
  const Interval fine = rescaled(x, bits, working);
  // y = fine / 2^doublings
  const Interval y = rescaled(fine, working + doublings, working);
  switch (function) {
    case Elementary::exp:
      return rescaled(series.exp(y, doublings), working, bits);
    case Elementary::cos:
      return clamped(rescaled(series.turn(y, doublings).cos, working, bits), Integer(1)
                                                                                 << bits);
    case Elementary::sin:
      return clamped(rescaled(series.turn(y, doublings).sin, working, bits), Integer(1)
                                                                                 << bits);
    case Elementary::log:
      demand(x.low > 0, "effort: a logarithm of a number that is not seen to be positive");
      return rescaled({series.log(fine.low).low, series.log(fine.high).high}, working, bits);
    case Elementary::pi:
      return rescaled(series.pi(), working, bits);
    case Elementary::none:
      break;
  }
  throw Open("malformed: an unknown function");
}

}  // namespace seam::check
