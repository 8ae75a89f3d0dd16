// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "geometry/matrix.h"
#include "geometry/nearness.h"

namespace seam::geometry {

/// Two vectors that are not parallel, and what it takes to carry them, and the vector across
/// them, elsewhere.
class Frame {
 public:
  /// The first two of the points that are not parallel, if there are any. Dimension 3.
  static std::optional<Frame> of(const std::vector<Point>&, Numbers&);

  /// The linear map with a -> x, b -> y and a x b -> x x y, or its negative if `mirrored`. It
  /// is orthogonal exactly if x and y have the dot products of a and b.
  Matrix carry(const Point& x, const Point& y, bool mirrored, const Numbers&) const;

  /// All ordered pairs i, j whose points have the dot products of a and b, decided exactly.
  std::vector<std::pair<int, int>> images(const std::vector<Point>&, const Numbers&) const;

 private:
  bool fits(const Point& x, const Point& y, const Numbers&) const;

  Frame(Point a, Point b, Numbers&);
  Point a_, b_;
  std::vector<Point> dual_;  ///< its products with a, b, a x b form the identity
};

}  // namespace seam::geometry
