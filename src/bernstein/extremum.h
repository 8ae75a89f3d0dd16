// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "exact/polynomial.h"

// Search only: where a maximum seems to be. That it is one is for a proof to show.
namespace seam::bernstein {

/// A face of a product of standard simplices: of each, some corners. Bit 0 is the origin, bit i
/// the i-th unit vector.
using Face = std::vector<unsigned>;

/// Where a function seems to have its maximum.
struct Spot {
  double value = 0;        ///< about
  Face face;               ///< lies in its interior
  std::vector<double> at;  ///< about, in coordinates of the face
  bool is_centre = false;  ///< all shares are equal; it need not be a critical point
};

/// numerator / denominator on a product of standard simplices of these dimensions; the
/// denominator is positive there. The variables of the ring are the coordinates, one factor
/// after the other.
class Landscape {
 public:
  Landscape(exact::Polynomial numerator, exact::Polynomial denominator,
            std::vector<int> dimensions);

  /// Corners, centres of faces, and critical points within faces whose value is about the
  /// largest found; those of small faces first. None where no value is finite.
  std::vector<Spot> highest() const;

  /// The function on a face. Its coordinates are the shares of the face's corners but the first
  /// of each factor.
  struct Restriction {
    exact::Polynomial numerator, denominator;
    std::vector<exact::Polynomial> place;  ///< the coordinates of the product in those
  };
  Restriction on(const Face&) const;

  /// Whether both are the same function.
  bool operator==(const Landscape&) const;

 private:
  exact::Polynomial numerator_, denominator_;
  std::vector<int> dimensions_;
};

}  // namespace seam::bernstein
