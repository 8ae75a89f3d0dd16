// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "exact/roots.h"

// Search only: where a maximum seems to be. That it is one is for a proof to show.
namespace seam::bernstein {

enum class Patch {
  triangle,  ///< u, v >= 0, u + v <= 1
  square     ///< 0 <= u, v <= 1
};

/// Where numerator / denominator seems to have its maximum.
struct Candidate {
  using Point = std::array<exact::Rational, 2>;
  double value = 0;  ///< about
  Point at;          ///< the simplest fractions nearby
  bool is_critical =
      false;  ///< `at` is a corner, or exactly a critical point (within its edge)

  /// Within an edge, where `at` is not exactly it: the point start + t * direction for the one
  /// root t in `root` of the squarefree polynomial `slope`.
  struct OnEdge {
    Point start, direction;
    exact::Univariate slope;
    exact::RootInterval root;
  };
  std::optional<OnEdge> on_edge;
};

/// All points found whose value is about the largest; at least one. Both polynomials are in two
/// variables, over one ring; the denominator is positive on the patch.
std::vector<Candidate> maximum(const exact::Polynomial& numerator,
                               const exact::Polynomial& denominator, Patch);

}  // namespace seam::bernstein
