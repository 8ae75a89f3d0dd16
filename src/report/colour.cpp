// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/colour.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <span>

namespace seam::report {
namespace {

constexpr std::array<std::uint32_t, 10> rising = {0x440154, 0x482878, 0x3e4989, 0x31688e,
                                                  0x26828e, 0x1f9e89, 0x35b779, 0x6ece58,
                                                  0xb5de2b, 0xfde725};
constexpr std::array<std::uint32_t, 9> two_sided = {
    0x3b4cc0, 0x6282ea, 0x8db0fe, 0xb8d0f9, 0xdddddd, 0xf5c4ad, 0xf49a7b, 0xde604d, 0xb40426};

Colour between(std::span<const std::uint32_t> stops, double t) {
  const double at = std::clamp(t, 0.0, 1.0) * static_cast<double>(stops.size() - 1);
  const auto stop = std::min(stops.size() - 2, static_cast<std::size_t>(at));
  const double part = at - static_cast<double>(stop);
  Colour result{};
  for (std::size_t i = 0; i < 3; ++i) {
    const unsigned shift = 16 - 8 * static_cast<unsigned>(i);
    const auto channel = [&](std::uint32_t c) { return ((c >> shift) & 0xFF) / 255.0; };
    result[i] = channel(stops[stop]) * (1 - part) + channel(stops[stop + 1]) * part;
  }
  return result;
}

// Multiples of 1, 2 or 5 times a power of ten.
std::vector<double> ticks(double low, double high) {
  constexpr double most = 6;
  const double span = high - low;
  if (!(span > 0)) return {low};
  const double power = std::pow(10, std::floor(std::log10(span / most)));
  double step = power;
  for (const double factor : {1.0, 2.0, 5.0, 10.0})
    if (span / (step = factor * power) <= most) break;
  std::vector<double> result;
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; ++k)
    result.push_back(k == 0 ? 0 : k * step);
  return result;
}

}  // namespace

Scale scale_of(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  Scale scale;
  if (values.empty()) return scale;
  std::ranges::sort(values);
  scale.low = scale.least = values.front();
  scale.high = scale.greatest = values.back();
  const auto quantile = [&](double part) {
    return values[static_cast<std::size_t>(part * static_cast<double>(values.size() - 1))];
  };
  const double lower = quantile(0.02), upper = quantile(0.98), bulk = upper - lower;
  if (bulk > 0 && scale.high - upper > 2 * bulk) {
    scale.high = upper + bulk / 10;
    scale.above = true;
  }
  if (bulk > 0 && lower - scale.low > 2 * bulk) {
    scale.low = lower - bulk / 10;
    scale.below = true;
  }
  const double size = std::max(std::abs(scale.low), std::abs(scale.high));
  if (scale.high - scale.low <= 1e-9 * size) scale.high = scale.low;
  scale.diverging = std::min(-scale.low, scale.high) > 1e-6 * size;
  scale.ticks = ticks(scale.low, scale.high);
  return scale;
}

Colour colour(const Scale& scale, double value) {
  const double span = scale.high - scale.low;
  if (scale.diverging)
    return between(two_sided, 0.5 + 0.5 * value / std::max(-scale.low, scale.high));
  return between(rising, span > 0 ? (value - scale.low) / span : 0.6);
}

std::string short_number(double value) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%.4g", value == 0 ? 0 : value);
  return buffer.data();
}

}  // namespace seam::report
