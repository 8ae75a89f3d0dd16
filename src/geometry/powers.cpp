// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/powers.h"

// The coefficient of s^j in A^m B^n, m > 0, is the sum of a_i times that of s^(j-i) in A^(m-1)
// B^n. The latter is 0 for j - i < m + n - 1, so i goes to j - m - n + 1 only.

namespace seam::geometry {

using symbolic::Formula;

void Powers::extend(Formula a, Formula b) {
  a_.push_back(std::move(a));
  b_.push_back(std::move(b));
}

const Formula& Powers::coefficient(int j, int m, int n) {
  const std::array<int, 3> key{j, m, n};
  if (const auto found = known_.find(key); found != known_.end()) return found->second;
  Formula value = m + n == 0 && j == 0 ? 1 : 0;
  if (m + n > 0) {
    const auto& series = m > 0 ? a_ : b_;
    std::vector<Formula> terms;
    for (int i = 1; i <= j - m - n + 1; ++i)
      terms.push_back(series.at(i) *
                      (m > 0 ? coefficient(j - i, m - 1, n) : coefficient(j - i, m, n - 1)));
    value = sum(std::move(terms));
  }
  return known_.emplace(key, std::move(value)).first->second;
}

}  // namespace seam::geometry
