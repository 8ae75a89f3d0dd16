// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/prove.h"

#include <utility>

#include "prove/strategies.h"

namespace seam::prove {

using certificate::Proof;

namespace {

// The table of strategies.
struct Strategy {
  Workshop& workshop;
  SignProver& signs;
  Proof operator()(const certificate::Zero& o) const { return prove_zero(workshop, o); }
  Proof operator()(const certificate::Sign& o) const { return signs.prove(o); }
  Proof operator()(const certificate::Solutions& o) const {
    return prove_solutions(workshop, o);
  }
  Proof operator()(const certificate::OnlySolutions& o) const {
    return prove_only_solutions(workshop, o);
  }
  Proof operator()(const certificate::OneSolution& o) const {
    return prove_one_solution(workshop, o);
  }
  Proof operator()(const certificate::Gluing&) const { return prove_by_computation(); }
  Proof operator()(const certificate::Distinct&) const { return prove_by_computation(); }
  Proof operator()(const certificate::Mesh&) const { return prove_by_computation(); }
};

Proof attempt(const Strategy& strategy, const certificate::Obligation& obligation) {
  if (strategy.workshop.late()) return certificate::Nothing{"time", "the time given was over"};
  try {
    return std::visit(strategy, obligation);
  } catch (const Unfit& error) {
    return certificate::Nothing{"unsupported", error.what()};
  }
}

}  // namespace

certificate::Evidence prove(const certificate::Statement& statement, const Budget& budget) {
  certificate::Evidence evidence;
  std::vector<Proof> proofs;
  try {
    Workshop workshop(statement, evidence, budget);
    SignProver signs(workshop);
    for (const auto& obligation : statement.obligations)
      proofs.push_back(attempt({workshop, signs}, obligation));
  } catch (const Unfit& error) {  // by its numbers
    proofs.assign(statement.obligations.size(),
                  certificate::Nothing{"unsupported", error.what()});
  }
  evidence.proofs = std::move(proofs);
  return evidence;
}

}  // namespace seam::prove
