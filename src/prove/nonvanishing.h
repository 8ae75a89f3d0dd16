// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "prove/equations.h"
#include "prove/subdivide.h"

namespace seam::prove {

/// Signs of polynomials over a domain, and every real value of further variables, where
/// conditions hold. All polynomials are in the variables of the factors, then those.
class Nonvanishing {
 public:
  using Conditions = std::vector<Condition>;
  using Trees = std::vector<certificate::SignProof>;

  Nonvanishing(Workshop&, const Equations&);

  /// Evidence that `f relation 0`, as `certificate::Elimination` describes it, or nothing. The
  /// relation is not `zero`. Takes a bounded number of pieces.
  std::optional<Trees> show(const exact::Polynomial& f, certificate::Relation,
                            const Conditions&);

 private:
  struct Known {
    exact::Polynomial f;
    certificate::Relation relation;
    Conditions conditions;
    std::optional<Trees> trees;
  };
  bool may_hold(const exact::Polynomial& f, certificate::Relation, const Conditions&) const;
  std::optional<Trees> search(const exact::Polynomial& f, certificate::Relation,
                              const Conditions&) const;
  std::optional<certificate::Pieces> search(const exact::Polynomial& f, certificate::Relation,
                                            const Conditions&, const Factors&) const;

  std::optional<certificate::SignProof> derive(const exact::Polynomial& f,
                                               certificate::Relation, const Conditions&,
                                               const Factors&) const;
  bool is_covered(const exact::Polynomial&, const Factors&) const;

  Workshop* workshop_;
  const Equations* stated_;
  std::vector<std::vector<double>> samples_;
  std::vector<Known> known_;
};

}  // namespace seam::prove
