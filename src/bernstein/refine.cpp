// SPDX-License-Identifier: GPL-3.0-or-later
#include "bernstein/refine.h"

#include <algorithm>
#include <cmath>

#include "bernstein/critical.h"
#include "exact/field.h"
#include "exact/recognise.h"

// Newton's method with the gradient exact and the Hessian in doubles: each round gains about as
// many bits as the Hessian at the start is right to. Ends: a round that gains none is the last.

namespace seam::bernstein {

using exact::Polynomial;
using exact::Rational;

std::optional<std::vector<Rational>> refined(const Polynomial& numerator,
                                             const Polynomial& denominator,
                                             const std::vector<double>& start, long bits) {
  const std::size_t size = start.size();
  std::vector<Polynomial> slopes, slopes_below;
  for (std::size_t i = 0; i < size; ++i) {
    slopes.push_back(numerator.derivative(static_cast<int>(i)));
    slopes_below.push_back(denominator.derivative(static_cast<int>(i)));
  }
  const Sketch::Jet jet = Sketch(numerator).jet(start), below = Sketch(denominator).jet(start);
  std::vector<std::vector<double>> hessian = jet.hessian;
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j)
      hessian[i][j] -= jet.value / below.value * below.hessian[i][j];

  const exact::RingPtr numbers = exact::Ring::make(numerator.ring().tower(), {});
  std::vector<Rational> at(start.begin(), start.end());
  for (long gained = 0; gained < bits;) {
    const long precision = std::min(bits, gained + 96) + 32;
    std::vector<Polynomial> here;
    for (Rational& x : at) {
      x = exact::truncated(x, precision);
      here.push_back(numbers->constant(x));
    }
    const auto value = [&](const Polynomial& f) {
      const auto e = exact::enclosure(f.substitute(numbers, here), 2 * precision);
      return Rational((e.low + e.high) / 2);
    };
    const Rational d = value(denominator);
    if (d == 0) return std::nullopt;
    const Rational ratio = value(numerator) / d;
    std::vector<double> slope;
    for (std::size_t i = 0; i < size; ++i) {
      const Rational s = slopes_below[i].is_zero()
                             ? value(slopes[i])
                             : Rational(value(slopes[i]) - ratio * value(slopes_below[i]));
      slope.push_back(exact::scaled(s, gained).get_d());
    }
    const auto step = solve(hessian, slope);
    if (step.empty()) return std::nullopt;
    double largest = 0x1p-90;
    for (std::size_t i = 0; i < size; ++i) {
      if (!std::isfinite(step[i])) return std::nullopt;
      largest = std::max(largest, std::abs(step[i]));
      at[i] -= exact::scaled(Rational(step[i]), -gained);
    }
    const long more = -std::ilogb(largest) - 2;
    if (more < 4) return std::nullopt;
    gained += more;
  }
  for (Rational& x : at) x = exact::truncated(x, bits + 32);
  return at;
}

}  // namespace seam::bernstein
