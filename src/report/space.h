// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

// Points and vectors in space, rounded: for drawings alone.
namespace seam::report {

using Vector = std::array<double, 3>;

inline Vector operator+(const Vector& a, const Vector& b) {
  return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
inline Vector operator-(const Vector& a, const Vector& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
inline Vector operator*(double s, const Vector& a) {
  return {s * a[0], s * a[1], s * a[2]};
}
inline double dot(const Vector& a, const Vector& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline double length(const Vector& a) {
  return std::hypot(a[0], a[1], a[2]);
}

/// Of length 1; not a number where the vector is 0.
inline Vector direction(const Vector& a) {
  return 1 / length(a) * a;
}

/// Whether all coordinates are numbers of a size that can be drawn.
inline bool is_drawable(const Vector& a) {
  constexpr double largest = 1e30;
  return std::abs(a[0]) < largest && std::abs(a[1]) < largest && std::abs(a[2]) < largest;
}

}  // namespace seam::report
