// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/curvature.h"

namespace seam::geometry {

/// A surface by formulas in parameter_u and parameter_v: its derivatives, and the domain. A
/// parameter that belongs to no factor of it ranges over all reals.
struct Chart {
  std::function<Point(int i, int j)> derivative;  ///< of orders 0, 0: the point
  symbolic::Domain domain;
};
Chart chart(const Patch&);
Chart chart(const Point&, symbolic::Domain);

/// A curve by formulas in parameter_u, on [0, 1] or, if not `is_segment`, on the real line.
struct Arc {
  std::function<Point(int order)> derivative;
  bool is_segment = true;
};
Arc arc(const Curve&);
Arc arc(const Point&, bool is_segment);

Point normal(const Chart&);
Quotient gauss(const Chart&);

}  // namespace seam::geometry
