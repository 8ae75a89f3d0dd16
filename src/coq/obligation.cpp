// SPDX-License-Identifier: GPL-3.0-or-later
#include "coq/obligation.h"

#include <algorithm>
#include <array>

#include "coq/domain.h"
#include "coq/draft.h"

// The theorem says what docs/certificates.md says of the obligation: of all numbers that the
// generators can be and all points of the domain, or that there is a point where it fails.

namespace seam::coq {
namespace {

using certificate::Certificate;
using certificate::Computation;
using certificate::Obligation;
using certificate::Pieces;
using certificate::Proof;
using certificate::Relation;
using certificate::Sign;
using certificate::Term;
using certificate::Witness;
using certificate::Zero;

constexpr std::array kinds = {"zero",         "sign",   "solutions", "only_solutions",
                              "one_solution", "gluing", "distinct",  "mesh"};

/// A zero or sign obligation, both as `formula relation 0` on a domain.
Sign as_sign(const Obligation& obligation) {
  if (const auto* zero = std::get_if<Zero>(&obligation))
    return {zero->formula, Relation::zero, {}};
  return std::get<Sign>(obligation);
}

std::vector<Term> terms_of(const Sign& sign) {
  std::vector<Term> terms = {sign.formula};
  for (const auto& condition : sign.domain.where) terms.push_back(condition.formula);
  return terms;
}

std::vector<Term> corners_of(const Sign& sign) {
  std::vector<Term> terms;
  for (const auto& factor : sign.domain.factors)
    for (const auto& corner : factor.corners)
      terms.insert(terms.end(), corner.begin(), corner.end());
  return terms;
}

std::vector<Term> terms_of(const Proof& proof) {
  std::vector<Term> terms;
  if (const auto* pieces = std::get_if<Pieces>(&proof))
    for (const auto& step : pieces->steps)
      terms.insert(terms.end(), step.weights.begin(), step.weights.end());
  if (const auto* witness = std::get_if<Witness>(&proof)) terms = witness->point.values;
  return terms;
}

const char* reason_of(const Proof& proof) {
  if (std::holds_alternative<certificate::Nothing>(proof)) return "undecided";
  if (std::holds_alternative<certificate::Reduction>(proof)) return "shown by a reduction";
  const auto* pieces = std::get_if<Pieces>(&proof);
  if (pieces != nullptr && pieces->square >= 0) return "a square factor";
  const auto* witness = std::get_if<Witness>(&proof);
  if (witness != nullptr && !witness->other.empty()) return "a change of sign";
  return nullptr;
}

bool holds_a_function(const std::set<std::string>& symbols, const Certificate& certificate) {
  return std::ranges::any_of(certificate.statement.functions, [&](const auto& function) {
    return symbols.contains(function.name);
  });
}

}  // namespace

Theorem write_theorem(const Certificate& certificate, std::size_t index, Shown shown,
                      const std::string& name) {
  const Obligation& obligation = certificate.statement.obligations[index];
  const Proof& proof = certificate.evidence.proofs[index];
  Theorem theorem{{}, kinds[obligation.index()], {}};
  const auto leave_out = [&](const std::string& why) {
    theorem.left_out = why;
    return theorem;
  };
  if (obligation.index() > 1) return leave_out("of another kind");
  if (const char* why = reason_of(proof)) return leave_out(why);

  const Sign sign = as_sign(obligation);
  const Formulas formulas(certificate);
  std::vector<Term> terms = terms_of(sign);
  const std::set<std::string> symbols = formulas.symbols(terms);
  if (holds_a_function(symbols, certificate)) return leave_out("with functions");
  std::vector<Term> numbers = corners_of(sign);
  const std::vector<Term> from_proof = terms_of(proof);
  numbers.insert(numbers.end(), from_proof.begin(), from_proof.end());
  std::set<std::string> all = formulas.symbols(numbers);
  all.insert(symbols.begin(), symbols.end());
  const auto generators = generators_among(all, certificate, formulas);
  if (!generators)
    return leave_out("with numbers that are no roots of polynomials of the statement");
  std::set<std::string> free = symbols;
  for (const auto& generator : certificate.statement.generators) free.erase(generator.name);

  Draft draft(certificate, terms, *generators);
  if (const auto* witness = std::get_if<Witness>(&proof)) {
    if (!write_witness(draft, sign, free, witness->point))
      return leave_out("a point of a simplex that is not written by inequalities");
  } else if (std::holds_alternative<Pieces>(proof)) {
    if (!write_pieces(draft, sign, free, std::get<Pieces>(proof)))
      return leave_out("a variable outside the domain");
  } else if (obligation.index() == 0 && shown != Shown::fails) {
    write_identity(draft, sign, free);
  } else if (shown != Shown::fails) {
    write_number(draft, sign, free);
  } else if (free.empty() && sign.domain.factors.empty()) {
    write_witness(draft, sign, free, {});
  } else {
    return leave_out("fails without a point");
  }
  theorem.text = draft.finish(name);
  return theorem;
}

}  // namespace seam::coq
