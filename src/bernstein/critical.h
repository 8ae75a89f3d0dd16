// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "exact/polynomial.h"

// Search only: doubles without any bound. What is found here is checked exactly elsewhere.
namespace seam::bernstein {

/// A polynomial in doubles.
class Sketch {
 public:
  explicit Sketch(const exact::Polynomial&);

  struct Jet {
    double value = 0;
    std::vector<double> gradient;
    std::vector<std::vector<double>> hessian;
  };
  Jet jet(const std::vector<double>& at) const;
  double value(const std::vector<double>& at) const;

 private:
  struct Term {
    std::vector<int> exponents;
    double coefficient;
  };
  std::size_t variables_;
  std::vector<int> degrees_;
  std::vector<Term> terms_;
};

/// A direction in which a point may move, and stay in the face it is to lie in.
using Direction = std::vector<double>;

/// A critical point of numerator / denominator (1 if null) in the plane through `start` along
/// the directions, by Newton's method; empty if it does not settle.
std::vector<double> critical_point(const Sketch& numerator, const Sketch* denominator,
                                   std::vector<double> start,
                                   const std::vector<Direction>& directions);

/// The x with matrix * x = right, or empty if singular.
std::vector<double> solve(std::vector<std::vector<double>> matrix, std::vector<double> right);

}  // namespace seam::bernstein
