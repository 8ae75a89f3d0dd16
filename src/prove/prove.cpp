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
  Proof operator()(const certificate::Zero& o) const { return prove_zero(workshop, o); }
  Proof operator()(const certificate::Sign& o) const { return prove_sign(workshop, o); }
  Proof operator()(const certificate::Solutions& o) const { return prove_solutions(workshop, o); }
  Proof operator()(const certificate::Gluing&) const { return prove_by_computation(); }
  Proof operator()(const certificate::Distinct&) const { return prove_by_computation(); }
};

Proof attempt(Workshop& workshop, const certificate::Obligation& obligation) {
  if (workshop.late()) return certificate::Nothing{"time", "the time given was over"};
  try {
    return std::visit(Strategy{workshop}, obligation);
  } catch (const Unfit& error) {
    return certificate::Nothing{"unsupported", error.what()};
  }
}

}  // namespace

certificate::Evidence prove(const certificate::Statement& statement, const Budget& budget) {
  certificate::Evidence evidence;
  Workshop workshop(statement, evidence, budget);
  std::vector<Proof> proofs;
  for (const auto& obligation : statement.obligations)
    proofs.push_back(attempt(workshop, obligation));
  evidence.proofs = std::move(proofs);
  return evidence;
}

}  // namespace seam::prove
