// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "geometry/normal_form.h"

// Search by doubles: finds what may be equal, so that the exact test is made only there. Never
// decides that points are equal; and points that are equal are always near.
namespace seam::geometry {

using Approximation = std::vector<double>;
Approximation approximate(const Point&, const Numbers&);
std::vector<Approximation> approximate(const std::vector<Point>&, const Numbers&);

bool near(double a, double b);
bool near(double a, double b,
          double size);  ///< for sums of terms that add up to `size` in absolute value
bool near(const Approximation& a, const Approximation& b);

double dot(const Approximation& a, const Approximation& b);
Approximation operator-(const Approximation& a, const Approximation& b);

/// Each point once, in normal form, in the order of first occurrence.
std::vector<Point> distinct(const std::vector<Point>&, const Numbers&);

/// Points to be found again.
class PointIndex {
 public:
  PointIndex(const std::vector<Point>& points, const Numbers& numbers);

  /// The first point that is equal, decided exactly.
  std::optional<int> find(const Point&) const;

 private:
  std::vector<Point> points_;
  std::vector<Approximation> approximations_;
  const Numbers& numbers_;
};

}  // namespace seam::geometry
