// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "coq/formula.h"

namespace seam::coq {

/// The generators that a theorem speaks of: real numbers in their intervals at which their
/// polynomials are 0.
struct Generators {
  std::string quantified;  ///< `forall g : R, low <= g <= high -> polynomial = 0 ->`, for each
  std::string intros;      ///< names for all of that
  std::string arguments;   ///< what the theorems of the library are given first: `gs gens`
  std::string proof;       ///< of `roots gs gens`
};

/// The positions of the generators of the statement that these symbols, and the polynomials of
/// those found, hold; nothing if there is one that is no root of a polynomial or one of the
/// evidence.
std::optional<std::vector<std::size_t>> generators_among(const std::set<std::string>& symbols,
                                                         const certificate::Certificate&,
                                                         const Formulas&);

/// Takes the first places among the values.
Generators write_generators(const std::vector<std::size_t>&, const certificate::Certificate&,
                            Formulas&, Names&);

}  // namespace seam::coq
