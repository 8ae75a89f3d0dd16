// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <utility>

#include "report/space.h"

namespace seam::report {

/// The edges of the facets of a closed surface, told apart by rounded coordinates: which of
/// them border a facet that looks towards the eye. The others are hidden, however thin the
/// surface is there.
class FacingEdges {
 public:
  void add(const std::array<Vector, 3>& corners, bool looks_here);
  /// It is an edge of a facet that looks towards the eye.
  bool face_here(const Vector& from, const Vector& to) const {
    return facing_.contains(edge(from, to));
  }
  /// It is an edge of facets that all look away.
  bool turn_away(const Vector& from, const Vector& to) const;

 private:
  using Key = std::array<long, 3>;
  using Edge = std::pair<Key, Key>;
  static Edge edge(const Vector& a, const Vector& b);

  std::set<Edge> all_, facing_;
};

}  // namespace seam::report
