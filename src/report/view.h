// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "report/run.h"
#include "report/space.h"

namespace seam::report {

/// Where the eye is: all is seen from far away, so that parallel lines stay so. What lies in a
/// plane x = const, y = const or z = const is seen from the front, all else from obliquely
/// above.
class View {
 public:
  explicit View(const FigureRun&);

  /// Right, up, and towards the eye; the figure fills [-1, 1] in its larger direction.
  Vector operator()(const Vector& point) const;
  Vector turned(const Vector& direction) const;
  double half_width() const { return half_[0]; }
  double half_height() const { return half_[1]; }

 private:
  Vector right_{}, up_{}, eye_{};
  Vector middle_{};  ///< in the frame of the view
  double factor_ = 1;
  std::array<double, 2> half_{};
};

/// Which points of a view the facets hide: their nearest depths on a grid.
class DepthGrid {
 public:
  using Triangle = std::array<Vector, 3>;  ///< in the coordinates of the view
  explicit DepthGrid(const std::vector<Triangle>&);

  /// Whether something nearer lies in front, by more than the thickness of a line; if
  /// `all_round`, in front of all that is next to the point, too.
  bool hides(const Vector& point, bool all_round) const;
  /// By the number of the triangle.
  bool shows(std::size_t triangle) const { return seen_[triangle]; }

 private:
  static constexpr int cells = 640;  ///< a side
  std::vector<double> depth_;
  std::vector<bool> seen_;
};

}  // namespace seam::report
