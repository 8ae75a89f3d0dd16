// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "prove/workshop.h"

// One strategy for each kind of obligation.
namespace seam::prove {

certificate::Proof prove_zero(Workshop&, const certificate::Zero&);

/// Remembers what it decided: many patches of a surface share one polynomial.
class SignProver {
 public:
  explicit SignProver(Workshop& workshop) : workshop_(&workshop) {}
  certificate::Proof prove(const certificate::Sign&);

 private:
  struct Settled {
    certificate::Sign sign;
    exact::Polynomial f;
    certificate::Proof proof;
  };
  Workshop* workshop_;
  std::vector<Settled> settled_;
};

certificate::Proof prove_solutions(Workshop&, const certificate::Solutions&);

certificate::Proof prove_only_solutions(Workshop&, const certificate::OnlySolutions&);
certificate::Proof prove_one_solution(Workshop&, const certificate::OneSolution&);

/// A finite count: the checker does it.
certificate::Proof prove_by_computation();

}  // namespace seam::prove
