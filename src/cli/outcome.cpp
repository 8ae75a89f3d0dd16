// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/outcome.h"

#include <algorithm>

#include "certificate/json.h"
#include "check/judge.h"
#include "claims/latex.h"
#include "cli/formulas.h"
#include "cli/obligation_text.h"
#include "cli/refutation.h"
#include "cli/slack.h"

namespace seam::cli {
namespace {

using certificate::Evidence;
using certificate::Statement;
using certificate::Verdict;

std::string kind_of(const certificate::Obligation& obligation) {
  static const char* const names[] = {"zero",      "sign",   "solutions", "solutions",
                                      "solutions", "gluing", "distinct",  "mesh"};
  return names[obligation.index()];
}

struct Summary {
  std::string method, line;
};

Summary summary_of(const certificate::Obligation& obligation, const certificate::Proof& proof,
                   Formulas& formulas) {
  if (const auto* nothing = std::get_if<certificate::Nothing>(&proof))
    return {"", nothing->reason + ": " + nothing->detail};
  if (std::holds_alternative<certificate::Computation>(proof)) {
    if (std::holds_alternative<certificate::Zero>(obligation))
      return {"normal form", "the normal form is 0"};
    if (std::holds_alternative<certificate::Sign>(obligation))
      return {"enclosure", "the number is computed"};
    return {"count", "counted"};
  }
  if (const auto* pieces = std::get_if<certificate::Pieces>(&proof)) {
    const auto leaves = std::ranges::count_if(
        pieces->steps, [](const auto& s) { return s.kind != certificate::Step::Kind::split; });
    const std::string square = pieces->square >= 0 ? "a square factor taken out; " : "";
    return {"subdivision", square + "subdivision, " + std::to_string(leaves) +
                               (leaves == 1 ? " piece" : " pieces")};
  }
  if (std::holds_alternative<certificate::Reduction>(proof))
    return {"reduction", "reduced to other signs, then subdivision"};
  if (const auto* witness = std::get_if<certificate::Witness>(&proof))
    return {"witness", "witness " + point_text(witness->point, formulas)};
  if (std::holds_alternative<certificate::Roots>(proof))
    return {"roots", "greatest common divisor and its roots"};
  if (std::holds_alternative<certificate::Isolation>(proof))
    return {"isolation", "a box that holds a solution"};
  if (const auto* elimination = std::get_if<certificate::Elimination>(&proof))
    return {"elimination", "elimination, " + std::to_string(elimination->steps.size()) +
                               (elimination->steps.size() == 1 ? " step" : " steps")};
  return {"witness", "a wrong solution"};
}

bool is_elementary(const Statement& statement) {
  return std::ranges::any_of(statement.generators,
                             [](const auto& number) {
                               return number.function != certificate::Elementary::none;
                             }) ||
         !std::ranges::all_of(statement.functions, [](const auto& f) { return f.is_root(); });
}

// The prover works with numbers near transcendental ones. What it found and the checker did not
// accept is taken back: it was a guess.
bool withdraw_guesses(const Statement& statement, Evidence& evidence,
                      const check::Judgement& judgement) {
  if (!is_elementary(statement)) return false;
  bool changed = false;
  for (std::size_t i = 0; i < evidence.proofs.size(); ++i) {
    if (judgement.findings[i].kind != check::Finding::Kind::open ||
        std::holds_alternative<certificate::Nothing>(evidence.proofs[i]))
      continue;
    std::string reason = judgement.findings[i].reason;
    if (reason.starts_with("effort: ")) reason.erase(0, 8);
    evidence.proofs[i] = certificate::Nothing{"effort", reason};
    changed = true;
  }
  return changed;
}

}  // namespace

certificate::Evidence no_evidence(const Statement& statement, const std::string& reason,
                                  const std::string& detail) {
  Evidence evidence;
  evidence.proofs.assign(statement.obligations.size(), certificate::Nothing{reason, detail});
  return evidence;
}

Decided not_judged(const claims::Lowered& lowered, const claims::Expression& statement,
                   const claims::Refusal& why) {
  Decided result;
  report::Outcome& outcome = result.outcome;
  const Statement& claimed = lowered.exported->statement;
  outcome.text = claims::format(statement);
  outcome.latex = claims::latex(statement);
  outcome.digest = certificate::digest(claimed);
  outcome.reason = why.reason;
  outcome.detail = "judging its evidence: " + why.detail;
  result.evidence = no_evidence(claimed, outcome.reason, outcome.detail);
  return result;
}

Decided judged(const claims::Lowered& lowered, const claims::Expression& statement,
               Evidence evidence, const NormalForm& normal_form) {
  Decided result;
  report::Outcome& outcome = result.outcome;
  outcome.text = claims::format(statement);
  outcome.latex = claims::latex(statement);
  if (!lowered.exported) {
    outcome.reason = lowered.reason;
    outcome.detail = lowered.unsupported;
    return result;
  }
  const Statement& claimed = lowered.exported->statement;
  outcome.digest = certificate::digest(claimed);
  result.evidence = std::move(evidence);
  check::Judgement judgement = check::judge(claimed, result.evidence);
  if (withdraw_guesses(claimed, result.evidence, judgement))
    judgement = check::judge(claimed, result.evidence);
  outcome.verdict = judgement.verdict;

  Formulas formulas(claimed, result.evidence);
  const std::set<int> denied = only_denied(claimed);
  for (std::size_t i = 0; i < claimed.obligations.size(); ++i) {
    const certificate::Proof& proof = result.evidence.proofs[i];
    const check::Finding& finding = judgement.findings[i];
    const Summary summary = summary_of(claimed.obligations[i], proof, formulas);
    report::ObligationRun run;
    run.about = lowered.exported->about[i];
    if (denied.contains(static_cast<int>(i)))
      run.about += run.about.empty() ? "shown if this fails" : ", shown if this fails";
    run.kind = kind_of(claimed.obligations[i]);
    run.text = obligation_text(claimed.obligations[i], formulas);
    if (run.text.empty()) run.text = readable(lowered.exported->text[i]);
    run.guard = std::ranges::find(claimed.guards, static_cast<int>(i)) != claimed.guards.end();
    run.status = static_cast<report::ObligationRun::Status>(finding.kind);
    run.evidence = summary.line;
    outcome.obligations.push_back(std::move(run));
    if (!summary.method.empty() &&
        std::ranges::find(outcome.method, summary.method) == outcome.method.end())
      outcome.method.push_back(summary.method);
    const bool offered = !std::holds_alternative<certificate::Nothing>(proof);
    if (offered && finding.kind == check::Finding::Kind::open &&
        !finding.reason.starts_with("effort") && outcome.alarm.empty())
      outcome.alarm = run.kind + ": " + finding.reason;
  }
  if (outcome.verdict == Verdict::refuted)
    outcome.witness = witness_of(claimed, result.evidence, judgement, *lowered.exported,
                                 formulas, normal_form);
  add_slacks(outcome, *lowered.exported);
  if (outcome.verdict != Verdict::undecided) return result;

  // The prover says best why it found nothing; else a guard failed, or the checker gave up.
  for (std::size_t i = 0; i < result.evidence.proofs.size(); ++i) {
    const auto* nothing = std::get_if<certificate::Nothing>(&result.evidence.proofs[i]);
    if (!nothing || nothing->reason.empty() ||
        judgement.findings[i].kind != check::Finding::Kind::open)
      continue;
    outcome.reason = nothing->reason;
    outcome.detail = nothing->detail;
    return result;
  }
  outcome.reason = judgement.reason.starts_with("degenerate") ? "degenerate" : "effort";
  outcome.detail = judgement.reason;
  for (const auto& run : outcome.obligations)
    if (run.guard && run.status == report::ObligationRun::Status::fails) {
      outcome.detail = "what the claim rests on does not hold: " +
                       (run.about.empty() ? "" : run.about + ": ") + run.text + " (" +
                       run.evidence + ")";
      break;
    }
  return result;
}

}  // namespace seam::cli
