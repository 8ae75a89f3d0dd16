// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/judge_again.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <optional>
#include <set>
#include <variant>
#include <vector>

#include "certificate/json.h"
#include "check/judge.h"
#include "cli/files.h"

// First each statement by itself, then what the claims rest on. What is proven without
// condition grows from nothing, so that claims which use each other in a circle establish
// nothing.

namespace seam::cli {
namespace {

namespace fs = std::filesystem;
using certificate::Certificate;
using certificate::Verdict;

/// A statement of a run and its certificate.
struct Exhibit {
  const report::ClaimRun* claim = nullptr;
  report::Outcome* outcome = nullptr;
  bool correction = false;
  std::optional<Certificate> certificate;
  std::string objection;  ///< empty: none
};

bool is_in_its_folder(const std::string& name) {
  const fs::path path(name);
  return path.parent_path() == "certificates" && path.extension() == ".json";
}

bool is_what_was_found(const std::vector<report::ObligationRun>& said,
                       const std::vector<check::Finding>& found) {
  return std::ranges::equal(said, found, [](const auto& obligation, const auto& finding) {
    return static_cast<int>(obligation.status) == static_cast<int>(finding.kind);
  });
}

std::string objection(const Exhibit& exhibit, const Certificate& certificate) {
  const report::Outcome& outcome = *exhibit.outcome;
  if (certificate.claim != exhibit.claim->id || certificate.correction != exhibit.correction)
    return "its certificate is that of another claim";
  if (certificate::digest(certificate.statement) != outcome.digest)
    return "its certificate is about another statement";
  if (certificate.verdict != outcome.verdict)
    return std::string("its certificate says: ") + report::word(certificate.verdict);
  if (certificate.using_claims != exhibit.claim->using_claims)
    return "its certificate rests on other claims";
  const check::Judgement judgement = check::judge(certificate.statement, certificate.evidence);
  const Verdict shown =
      outcome.verdict == Verdict::conditional ? Verdict::proven : outcome.verdict;
  if (judgement.verdict != shown)
    return std::string("its evidence shows: ") + report::word(judgement.verdict) +
           (judgement.reason.empty() ? "" : ", " + judgement.reason);
  const bool is_open = outcome.verdict == Verdict::undecided && outcome.obligations.empty();
  if (!is_open && !is_what_was_found(outcome.obligations, judgement.findings))
    return "its evidence shows something else of its obligations";
  return {};
}

// The certificate, or why there is none.
std::variant<Certificate, std::string> certificate_of(const std::string& name,
                                                      const fs::path& folder) {
  if (name.empty()) return "it has no certificate";
  if (!is_in_its_folder(name)) return "its certificate is not in the folder certificates";
  try {
    return certificate::read(open(folder / name)->bytes);
  } catch (const Failure&) {
    return "its certificate is missing";
  } catch (const std::exception& error) {
    return std::string("its certificate cannot be read: ") + error.what();
  }
}

void judge(Exhibit& exhibit, const fs::path& folder) {
  const report::Outcome& outcome = *exhibit.outcome;
  if (outcome.certificate.empty() && outcome.verdict == Verdict::undecided) return;
  auto found = certificate_of(outcome.certificate, folder);
  if (const auto* reason = std::get_if<std::string>(&found)) {
    exhibit.objection = *reason;
    return;
  }
  exhibit.certificate = std::get<Certificate>(std::move(found));
  exhibit.objection = objection(exhibit, *exhibit.certificate);
}

std::string objection(const report::Confirmation& confirmed, const std::set<std::string>& names,
                      const Certificate& certificate) {
  const std::string name = certificate.claim + (certificate.correction ? ".corrected" : "");
  if (!names.contains(name)) return "its certificate is that of another claim";
  if (certificate::digest(certificate.statement) != confirmed.digest)
    return "its certificate is about another statement";
  const check::Judgement judgement = check::judge(certificate.statement, certificate.evidence);
  if (certificate.verdict != Verdict::proven || judgement.verdict != Verdict::proven)
    return std::string("its evidence shows: ") + report::word(judgement.verdict) +
           (judgement.reason.empty() ? "" : ", " + judgement.reason);
  return {};
}

// Whether what is said beside the claims is confirmed by the certificate of one of these names.
bool is_confirmed(report::Confirmation& confirmed, const std::set<std::string>& names,
                  const fs::path& folder, std::map<std::string, Certificate>& certificates) {
  auto found = certificate_of(confirmed.certificate, folder);
  auto* const certificate = std::get_if<Certificate>(&found);
  const std::string objected =
      certificate ? objection(confirmed, names, *certificate) : std::get<std::string>(found);
  if (objected.empty()) {
    certificates[confirmed.certificate] = std::move(*certificate);
    return true;
  }
  confirmed = {{}, {}, confirmed.alarm.empty() ? objected : confirmed.alarm};
  return false;
}

void judge_beside_claims(report::FileRun& file, const fs::path& folder,
                         std::map<std::string, Certificate>& certificates) {
  for (report::AskRun* ask : report::questions(file)) {
    if (ask->decimal.empty() && ask->closed_form.empty()) continue;
    if (is_confirmed(ask->confirmed, {ask->id}, folder, certificates)) continue;
    ask->decimal.clear();
    ask->closed_form.clear();
    ask->detail = "the answer of the results is not borne out";
  }
  for (report::ClaimRun* claim : report::claims(file))
    if (!claim->true_digits.empty() &&
        !is_confirmed(claim->digits_confirmed,
                      {claim->id + "~digits", claim->id + ".corrected"}, folder, certificates))
      claim->true_digits.clear();
}

void withdraw(report::Outcome& outcome, const std::string& objection) {
  outcome.verdict = Verdict::undecided;
  outcome.reason = "assumption";
  outcome.detail = "the verdict of the results is not borne out";
  outcome.witness.clear();
  outcome.method.clear();
  for (report::ObligationRun& obligation : outcome.obligations) {
    obligation.status = report::ObligationRun::Status::open;
    obligation.slack = {};
  }
  if (outcome.alarm.empty()) outcome.alarm = objection;
}

/// The first claim it rests on that is not among these; empty: none.
std::string unproven(const report::ClaimRun& claim, const std::set<std::string>& proven) {
  const auto used = std::ranges::find_if(
      claim.using_claims, [&](const std::string& id) { return !proven.contains(id); });
  return used == claim.using_claims.end() ? "" : *used;
}

std::set<std::string> established(const report::FileRun& file) {
  std::set<std::string> proven;
  for (bool grows = true; grows;) {
    grows = false;
    for (const report::ClaimRun* claim : report::claims(file))
      if (claim->printed.verdict == Verdict::proven && unproven(*claim, proven).empty())
        grows = proven.insert(claim->id).second || grows;
  }
  return proven;
}

// What the results say of conditions, before anything is withdrawn.
void check_conditions(const report::FileRun& file, std::vector<Exhibit>& exhibits) {
  const std::set<std::string> proven = established(file);
  for (Exhibit& exhibit : exhibits) {
    const std::string used = unproven(*exhibit.claim, proven);
    const Verdict verdict = exhibit.outcome->verdict;
    if (!exhibit.objection.empty()) continue;
    if (verdict == Verdict::proven && !used.empty())
      exhibit.objection = "it rests on '" + used + "', which is not proven";
    if (verdict == Verdict::conditional && used.empty())
      exhibit.objection = "all that it rests on is proven";
  }
}

void make_conditional(report::Outcome& outcome, const std::string& used) {
  if (outcome.verdict != Verdict::proven || used.empty()) return;
  outcome.verdict = Verdict::conditional;
  outcome.reason = "assumption";
  outcome.detail = "rests on '" + used + "', which is not proven";
}

}  // namespace

std::map<std::string, Certificate> judge_again(report::FileRun& file, const fs::path& folder,
                                               int jobs) {
  std::vector<Exhibit> exhibits;
  for (report::ClaimRun* claim : report::claims(file)) {
    exhibits.push_back({claim, &claim->printed, false, {}, {}});
    if (claim->corrected) exhibits.push_back({claim, &*claim->corrected, true, {}, {}});
  }
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  std::max(1, jobs));
  tbb::parallel_for(std::size_t{0}, exhibits.size(),
                    [&](std::size_t i) { judge(exhibits[i], folder); });
  check_conditions(file, exhibits);

  std::map<std::string, Certificate> certificates;
  for (Exhibit& exhibit : exhibits) {
    if (!exhibit.objection.empty()) withdraw(*exhibit.outcome, exhibit.objection);
    if (exhibit.certificate)
      certificates[exhibit.outcome->certificate] = std::move(*exhibit.certificate);
    else
      exhibit.outcome->certificate.clear();
  }
  judge_beside_claims(file, folder, certificates);
  const std::set<std::string> proven = established(file);
  for (const Exhibit& exhibit : exhibits)
    make_conditional(*exhibit.outcome, unproven(*exhibit.claim, proven));
  return certificates;
}

}  // namespace seam::cli
