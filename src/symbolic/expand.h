// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <unordered_map>

#include "exact/polynomial.h"
#include "symbolic/atoms.h"
#include "symbolic/formula.h"

namespace seam::symbolic {

/// What formulas are, expanded, in one ring; a shared node is expanded once. Keeps the formulas
/// alive. Roots and inverses of functions are variables of the ring, under the names that
/// `Atoms` gives them. Roots are reduced on the way: no power of one reaches its index.
class Expansion {
 public:
  /// `values`: numbers for some of the symbols, over the tower of the ring or a lower one.
  explicit Expansion(exact::RingPtr ring, Atoms atoms = {},
                     std::map<std::string, exact::Polynomial> values = {});

  /// From now on the square of variable `sine` is 1 less that of variable `cosine`.
  void add_circle(int sine, int cosine);

  /// Requires every symbol and atom of the formula to be one of the ring.
  exact::Polynomial operator()(const Formula&);
  const exact::RingPtr& ring() const { return ring_; }

 private:
  struct Rule {
    int variable, index;
    exact::Polynomial radicand;
  };
  exact::Polynomial compute(const Formula&);
  exact::Polynomial reduced(exact::Polynomial) const;
  exact::Polynomial power(const exact::Polynomial& base, int exponent) const;
  exact::RingPtr ring_;
  Atoms atoms_;
  std::map<std::string, exact::Polynomial> values_;
  std::vector<Rule> rules_;  ///< a radicand holds roots before its own
  std::unordered_map<const void*, std::pair<Formula, exact::Polynomial>> done_;
};

/// A rational times powers of symbols, variables and generators.
struct Monomial {
  exact::Rational coefficient;
  Formula powers;  ///< 1, or a product without a constant
};
/// What a polynomial is the sum of, the same for equal ones.
std::vector<Monomial> monomials(const exact::Polynomial&);
/// The formula of a polynomial: their sum.
Formula formula(const exact::Polynomial&);

}  // namespace seam::symbolic
