// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <vector>

#include "symbolic/formula.h"

namespace seam::geometry {

/// The coefficients of the products A^m B^n of two power series without constant terms, A = a_1
/// s + a_2 s^2 + …, B = b_1 s + …, of which more and more coefficients become known. Each is
/// built once, so formulas share it.
class Powers {
 public:
  /// The next coefficients of A and B.
  void extend(symbolic::Formula a, symbolic::Formula b);

  /// That of s^j in A^m B^n. Requires a_i and b_i known for i <= j - m - n + 1.
  const symbolic::Formula& coefficient(int j, int m, int n);

 private:
  std::vector<symbolic::Formula> a_{0}, b_{0};
  std::map<std::array<int, 3>, symbolic::Formula> known_;
};

}  // namespace seam::geometry
