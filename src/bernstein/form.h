// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "bernstein/shape.h"
#include "exact/field.h"
#include "exact/rows.h"

namespace seam::bernstein {

/// A point of a simplex, by weights of its corners: none negative, not all 0, integer
/// coordinates.
///
/// Exactly, corners are as they come, and the new one is their weighted sum, so that all stays
/// integral. In doubles every corner is divided by its total (the factor by which it exceeds a
/// corner of total 1).
class Cut {
 public:
  Cut(std::vector<exact::Polynomial> weights, const std::vector<exact::Integer>& totals);

  const std::vector<exact::Polynomial>& weights() const { return weights_; }
  bool involves(int corner) const { return !weights_[corner].is_zero(); }

 private:
  friend class Form;
  std::vector<exact::Polynomial> weights_;
  std::vector<exact::Multiplier> multipliers_;
  std::vector<exact::Ball> shares_;  // weight * total, divided by their sum
};
using CutPtr = std::shared_ptr<const Cut>;

/// A polynomial over a product of simplices, by the multiples (product of exponents)! * c of
/// its coefficients c: up to one positive factor, its Bernstein coefficients. Taking another
/// point for a corner is de Casteljau's algorithm, without division.
///
/// Signs are decided by balls in doubles, exactly only where a ball holds 0. The exact
/// coefficients are made when first needed, from those of the form it was cut from. Copies
/// share.
class Form {
 public:
  /// `polynomial`, in the barycentric coordinates as variables, factor by factor, homogeneous
  /// in each.
  Form(const exact::Polynomial&, std::shared_ptr<const Shape>);

  const Shape& shape() const { return *node_->shape; }

  /// Over the part in which the cut point takes the place of a corner. Requires
  /// `cut.involves(corner)`.
  Form part(int factor, int corner, const CutPtr&) const;

  /// Surely right when not "unknown"; quick.
  enum class Guess { negative, unknown, positive };
  Guess guess(int index) const;
  exact::Sign sign(int index) const;

  /// About the Bernstein coefficient, up to one positive factor the same for all parts.
  double about(int index) const { return node_->balls[index].middle; }

 private:
  struct Node {
    std::shared_ptr<const Shape> shape;
    std::vector<exact::Ball> balls;
    std::shared_ptr<const Node> parent;
    int factor = 0, corner = 0;
    CutPtr cut;
    mutable std::unique_ptr<exact::Rows> rows;
    const exact::Rows& exact_rows() const;
  };
  explicit Form(std::shared_ptr<const Node> node) : node_(std::move(node)) {}
  std::shared_ptr<const Node> node_;
};

}  // namespace seam::bernstein
