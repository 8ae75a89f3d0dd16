// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include <cstddef>
#include <vector>

#include "check/region.h"

namespace seam::check {

/// A part of a region: for each factor, a simplex within it.
struct Piece {
  /// In the barycentric coordinates of the piece: the formula in question, then the
  /// formula of each condition of the region. Positive multiples, as in `in_barycentric`.
  std::vector<Polynomial> formulas;
  /// Of each: whether it holds no other symbols than those with a coordinate in a factor. Over
  /// a piece, no more is said of another.
  std::vector<bool> is_over_factors;
  /// By factor and corner: which corners of the factor have a positive share in it.
  std::vector<std::vector<Corners>> supports;
  int depth = 0;
};

/// The region itself.
Piece whole(Context&, const Region&, const Polynomial& formula);

/// The part in which sum weights_j corner_j takes the place of corner i of a factor. Requires
/// one number for each corner, none negative, that of i positive.
Piece part(Context&, const Region&, const Piece&, std::size_t factor,
           const Coordinates& weights, std::size_t i);

/// Whether the coefficients show `formula relation 0` at all points of the region in
/// the piece. False says nothing of the formula.
bool is_plain(Context&, const Region&, const Piece&, std::size_t formula,
              certificate::Relation);

}  // namespace seam::check
