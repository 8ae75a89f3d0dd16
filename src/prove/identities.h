// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "prove/linear_ideal.h"
#include "prove/region.h"

namespace seam::prove {

/// Signs of polynomials over the factors and, for other variables, all reals, where conditions
/// hold: shown by identities that make them products and sums of squares.
class Identities {
 public:
  /// The polynomials are in these variables, those of the factors first.
  Identities(Workshop&, Factors, std::vector<std::string> names, std::vector<Condition> where);

  /// Nothing if no proof was found.
  std::optional<certificate::SignProof> show(const exact::Polynomial& f, certificate::Relation);

 private:
  using Shown = std::optional<certificate::SignProof>;
  /// number * product of bases^exponents
  struct Product {
    exact::Polynomial number;
    std::vector<std::pair<exact::Polynomial, int>> powers;
  };
  /// A product of conditions that exclude 0 is cofactor * f.
  struct Excluded {
    std::vector<int> conditions;
    exact::Polynomial cofactor;
  };
  /// sum weights[i] * bases[i]^2
  struct Squares {
    std::vector<exact::Polynomial> weights, bases;
  };

  Shown show(exact::Polynomial f, certificate::Relation, int depth);
  Shown show_zero(const exact::Polynomial& f, int depth);
  Shown by_multiple(const exact::Polynomial& f, const exact::Polynomial& equation,
                    const std::map<std::size_t, exact::Polynomial>& cofactors, int depth);
  Shown by_condition(const exact::Polynomial& f, certificate::Relation);
  Shown by_factors(const exact::Polynomial& f, certificate::Relation, int depth);
  Shown show_nonzero(const exact::Polynomial& base, int depth);
  Shown by_squares(const exact::Polynomial& f, certificate::Relation, int depth);
  Shown by_sum(const exact::Polynomial& f, certificate::Relation, int depth);
  Shown by_pieces(const exact::Polynomial& f, certificate::Relation);
  Shown square(const exact::Polynomial& base, bool is_strict);

  std::optional<Squares> squares(const exact::Polynomial& f) const;
  std::optional<Excluded> excluded(const exact::Polynomial& base) const;
  Product factored(const exact::Polynomial&) const;
  certificate::SignProof combined(const std::map<std::size_t, exact::Polynomial>& cofactors,
                                  certificate::SignProof rest);
  exact::Polynomial now(const exact::Polynomial&) const;

  Workshop& workshop_;
  Factors factors_;
  std::vector<std::string> names_;
  std::vector<Condition> where_;
  std::vector<Product> products_;  ///< of the conditions
  std::vector<int> equations_;     ///< by generator of the ideal: the condition
  LinearIdeal ideal_;
};

}  // namespace seam::prove
