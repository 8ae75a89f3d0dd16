// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "symbolic/formula.h"

namespace seam::symbolic {

/// A product as it is written: constant * factor^exponent * …, the factors different as trees,
/// no constants, products or powers among them.
struct Factors {
  exact::Rational constant = 1;
  std::vector<std::pair<Formula, int>> powers;
};
Factors factors(const Formula&);
Formula product(const Factors&);

/// a * b, factors that are the same as trees collected.
Formula merged_product(const Formula& a, const Formula& b);

/// A common multiple of two denominators: common = a * beside_a = b * beside_b. The least one,
/// as far as factors are the same as trees.
struct Common {
  Formula common, beside_a, beside_b;
};
Common common_denominator(const Formula& a, const Formula& b);

}  // namespace seam::symbolic
