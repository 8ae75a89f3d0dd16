// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/facing.h"

#include <algorithm>
#include <cmath>

namespace seam::report {

FacingEdges::Edge FacingEdges::edge(const Vector& a, const Vector& b) {
  constexpr double finest = 1e-6;  // in a view that is 2 wide
  const auto key = [](const Vector& x) {
    return Key{std::lround(x[0] / finest), std::lround(x[1] / finest),
               std::lround(x[2] / finest)};
  };
  return std::minmax(key(a), key(b));
}

void FacingEdges::add(const std::array<Vector, 3>& corners, bool looks_here) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Edge side = edge(corners[i], corners[(i + 1) % 3]);
    all_.insert(side);
    if (looks_here) facing_.insert(side);
  }
}

bool FacingEdges::turn_away(const Vector& from, const Vector& to) const {
  const Edge side = edge(from, to);
  return all_.contains(side) && !facing_.contains(side);
}

}  // namespace seam::report
