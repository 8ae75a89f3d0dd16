// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/patch.h"
#include "report/space.h"
#include "symbolic/numbers.h"

namespace seam::draw {

using report::cross, report::dot, report::length;
using report::Vector;
using report::operator+, report::operator-, report::operator*;

/// A point of a surface, with the derivatives there.
struct Jet {
  Vector point{}, u{}, v{}, uu{}, uv{}, vv{};

  Vector normal() const { return cross(u, v); }  ///< not normalised
  double gauss() const;
  double mean() const;  ///< positive where the surface bends towards D1 x D2
};

/// A patch in space with rounded control points: for drawings alone.
class RoundedPatch {
 public:
  using Shape = geometry::Patch::Shape;
  using Net = std::vector<std::vector<Vector>>;

  /// The patch is one in space (or in the plane: then z is 0) and holds no parameters.
  RoundedPatch(const geometry::Patch&, const symbolic::Numbers&);

  Shape shape() const { return shape_; }
  const Net& net() const { return net_; }
  Vector point(double u, double v) const;
  Jet jet(double u, double v) const;

 private:
  Shape shape_;
  Net net_;
  Net u_, v_, uu_, uv_, vv_;  ///< of the derivatives
};

}  // namespace seam::draw
