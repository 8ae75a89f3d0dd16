// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unordered_map>

#include "exact/polynomial.h"
#include "symbolic/formula.h"

namespace seam::symbolic {

/// What formulas are, expanded, in one ring; a shared node is expanded once. Keeps the formulas
/// alive.
class Expansion {
 public:
  explicit Expansion(exact::RingPtr ring) : ring_(std::move(ring)) {}

  /// Requires every symbol of the formula to be one of the ring.
  exact::Polynomial operator()(const Formula&);
  const exact::RingPtr& ring() const { return ring_; }

 private:
  exact::Polynomial compute(const Formula&);
  exact::RingPtr ring_;
  std::unordered_map<const void*, std::pair<Formula, exact::Polynomial>> done_;
};

/// The formula of a polynomial: sum of coefficient * powers of symbols, variables and
/// generators.
Formula formula(const exact::Polynomial&);

}  // namespace seam::symbolic
