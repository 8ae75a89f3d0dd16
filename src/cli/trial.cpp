// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/trial.h"

#include <algorithm>

#include "certificate/json.h"
#include "cli/decide.h"

namespace seam::cli {
namespace {

const claims::MeantClaim* find_claim(const claims::Meaning& meaning, const std::string& id) {
  for (const auto& item : meaning.items) {
    if (const auto* claim = std::get_if<claims::MeantClaim>(&item);
        claim && claim->claim.id == id)
      return claim;
    if (const auto* table = std::get_if<claims::MeantTable>(&item))
      for (const auto& row : table->rows)
        for (const auto& cell : row.cells)
          if (cell.claim.id == id) return &cell;
  }
  return nullptr;
}

std::string first_error(std::vector<text::Diagnostic> errors) {
  if (errors.empty()) return {};
  return std::ranges::min_element(errors, {}, [](const auto& e) { return e.where.begin; })
      ->message;
}

// Each field with its length before it.
void put(std::string& text, const std::string& field) {
  text += std::to_string(field.size()) + ":" + field;
}
std::string take(const std::string& text, std::size_t& at) {
  const std::size_t colon = text.find(':', at);
  const std::size_t size = std::stoul(text.substr(at, colon - at));
  at = colon + 1 + size;
  return text.substr(colon + 1, size);
}

}  // namespace

Trial try_claim(const std::string& text, const std::string& id, const VerifyOptions& options,
                const std::vector<std::string>& known) {
  const auto source = std::make_shared<const text::Source>(text::Source{id, text});
  const claims::Parsed parsed = claims::parse(source);
  Trial trial{first_error(parsed.errors), {}};
  if (!trial.error.empty()) return trial;
  const claims::Meaning meaning =
      claims::mean(parsed.file, [](const std::string&) { return nullptr; });
  trial.error = first_error(meaning.errors);
  const claims::MeantClaim* claim = find_claim(meaning, id);
  if (trial.error.empty() && !claim) trial.error = "the claim is no longer there";
  if (!trial.error.empty()) return trial;

  std::vector<std::pair<const claims::Lowered*, const claims::Expression*>> stated = {
      {&claim->printed, &claim->claim.statement}};
  if (claim->corrected) stated.emplace_back(&*claim->corrected, &*claim->claim.corrected);
  for (const auto& [lowered, expression] : stated) {
    TrialStatement& statement = trial.statements.emplace_back();
    if (lowered->exported) statement.digest = certificate::digest(lowered->exported->statement);
    if (std::ranges::find(known, statement.digest) != known.end()) continue;
    std::vector<Decided> decided =
        decide({{id, lowered, expression}}, options,
               [&](const symbolic::Formula& f) { return meaning.numbers->normal_form(f); });
    const report::Outcome& outcome = decided[0].outcome;
    statement.verdict = outcome.verdict;
    statement.reason = outcome.alarm.empty() ? outcome.reason : "alarm: " + outcome.alarm;
    if (lowered->exported)
      statement.certificate = certificate::write({id,
                                                  trial.statements.size() > 1,
                                                  outcome.verdict,
                                                  {},
                                                  lowered->exported->statement,
                                                  std::move(decided[0].evidence)});
  }
  return trial;
}

std::string write_trial(const Trial& trial) {
  std::string text;
  put(text, trial.error);
  for (const TrialStatement& statement : trial.statements) {
    put(text, report::word(statement.verdict));
    put(text, statement.reason);
    put(text, statement.digest);
    put(text, statement.certificate);
  }
  return text;
}

Trial read_trial(const std::string& text) {
  using report::Verdict;
  std::size_t at = 0;
  Trial trial{take(text, at), {}};
  while (at < text.size()) {
    const std::string word = take(text, at);
    TrialStatement& statement = trial.statements.emplace_back();
    for (const Verdict verdict :
         {Verdict::proven, Verdict::refuted, Verdict::conditional, Verdict::undecided})
      if (word == report::word(verdict)) statement.verdict = verdict;
    statement.reason = take(text, at);
    statement.digest = take(text, at);
    statement.certificate = take(text, at);
  }
  return trial;
}

}  // namespace seam::cli
