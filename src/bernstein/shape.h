// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace seam::bernstein {

/// The index set of a polynomial that is homogeneous in each of several groups of barycentric
/// coordinates, one group a simplex ("factor"), and its order.
class Shape {
 public:
  /// corners[k] coordinates and degree degrees[k] in factor k.
  Shape(std::vector<int> corners, std::vector<int> degrees);

  int factors() const { return static_cast<int>(corners_.size()); }
  int corners(int factor) const { return corners_[factor]; }
  int degree(int factor) const { return degrees_[factor]; }
  int count() const { return count_; }  ///< of coefficients

  /// The exponents in each factor.
  std::vector<std::vector<int>> exponents(int index) const;
  int index(const std::vector<std::vector<int>>& exponents) const;

  /// The coefficient of the pure power of one corner of each factor: the value at that corner.
  int corner(const std::vector<int>& corner_of_factor) const;

  /// The index with one unit of `from` moved to `to`, or -1 if there is none to move.
  int moved(int index, int factor, int from, int to) const;

  /// Which corners of the factor have exponent > 0, as bits.
  unsigned support(int index, int factor) const;

  /// The indices by falling exponent of that corner, with that exponent.
  struct Ranked {
    int index, exponent;
  };
  const std::vector<Ranked>& ranked(int factor, int corner) const {
    return ranked_[factor][corner];
  }

 private:
  int local(int index, int factor) const;
  std::vector<int> corners_, degrees_;
  int count_ = 1;
  std::vector<int> strides_;
  std::vector<std::vector<std::vector<int>>> monomials_;  // [factor][local]
  std::vector<std::vector<std::vector<int>>> moves_;      // [factor][local][from * n + to]
  std::vector<std::vector<std::vector<Ranked>>> ranked_;  // [factor][corner]
};

}  // namespace seam::bernstein
