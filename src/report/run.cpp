// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/run.h"

#include <algorithm>

namespace seam::report {
namespace {

void count(const FileRun& file, Summary& summary) {
  for (const ClaimRun* claim : claims(file)) {
    ++summary.claims;
    if (as_expected(*claim)) ++summary.as_expected;
    switch (claim->printed.verdict) {
      case Verdict::proven:
        ++summary.proven;
        break;
      case Verdict::refuted:
        ++summary.refuted;
        break;
      case Verdict::conditional:
        ++summary.conditional;
        break;
      case Verdict::undecided:
        ++summary.undecided;
        break;
    }
  }
}

template <typename Claim>
std::vector<Claim*> claims_in(auto& file) {
  std::vector<Claim*> found;
  for (auto& item : file.items) {
    if (auto* claim = std::get_if<ClaimRun>(&item)) found.push_back(claim);
    if (auto* table = std::get_if<TableRun>(&item))
      for (auto& row : table->rows)
        for (auto& cell : row.cells) found.push_back(&cell);
  }
  return found;
}

template <typename Ask>
std::vector<Ask*> questions_in(auto& file) {
  std::vector<Ask*> found;
  for (auto& item : file.items)
    if (auto* ask = std::get_if<AskRun>(&item)) found.push_back(ask);
  return found;
}

bool decided(const Outcome& outcome) {
  return outcome.verdict == Verdict::proven || outcome.verdict == Verdict::refuted;
}

int status(Concern concern, bool allow_undecided) {
  switch (concern) {
    case Concern::none:
      return 0;
    case Concern::undecided:
      return allow_undecided ? 0 : 2;
    case Concern::contradiction:
      return 1;
    case Concern::alarm:
      break;
  }
  return 3;
}

std::string in_short(const Outcome& outcome) {
  std::string text = word(outcome.verdict);
  for (const std::string& more :
       {outcome.alarm, outcome.witness, outcome.reason, outcome.detail})
    if (!more.empty()) text += "; " + more;
  return text;
}

}  // namespace

std::vector<const ClaimRun*> claims(const FileRun& file) {
  return claims_in<const ClaimRun>(file);
}

std::vector<ClaimRun*> claims(FileRun& file) {
  return claims_in<ClaimRun>(file);
}

std::vector<const AskRun*> questions(const FileRun& file) {
  return questions_in<const AskRun>(file);
}

std::vector<AskRun*> questions(FileRun& file) {
  return questions_in<AskRun>(file);
}

std::vector<std::pair<std::string, std::string>> alarms_beside_claims(const FileRun& file) {
  std::vector<std::pair<std::string, std::string>> alarms;
  for (const AskRun* ask : questions(file))
    if (!ask->confirmed.alarm.empty()) alarms.emplace_back(ask->id, ask->confirmed.alarm);
  for (const ClaimRun* claim : claims(file))
    if (!claim->digits_confirmed.alarm.empty())
      alarms.emplace_back(claim->id, claim->digits_confirmed.alarm);
  return alarms;
}

bool as_expected(const ClaimRun& claim) {
  return claim.printed.verdict == claim.expected &&
         (!claim.corrected || claim.corrected->verdict == Verdict::proven);
}

Summary summarize(const FileRun& file) {
  Summary summary;
  count(file, summary);
  return summary;
}

Summary summarize(const Run& run) {
  Summary summary;
  for (const FileRun& file : run.files) count(file, summary);
  return summary;
}

std::string path_of(const FileRun& file, const std::string& included) {
  const std::string& own = file.path.empty() ? file.file : file.path;
  return included.empty() ? own : own.substr(0, own.rfind('/') + 1) + included;
}

Concern concern(const ClaimRun& claim) {
  if (!claim.printed.alarm.empty() || (claim.corrected && !claim.corrected->alarm.empty()))
    return Concern::alarm;
  if (as_expected(claim)) return Concern::none;
  if (decided(claim.printed) && claim.printed.verdict != claim.expected)
    return Concern::contradiction;
  if (claim.corrected && claim.corrected->verdict == Verdict::refuted)
    return Concern::contradiction;
  return Concern::undecided;
}

std::string in_short(const ClaimRun& claim) {
  std::string text = in_short(claim.printed);
  if (claim.printed.verdict != claim.expected)
    text += std::string(" (expected: ") + word(claim.expected) + ")";
  if (claim.corrected) text += "; corrected: " + in_short(*claim.corrected);
  return text;
}

int exit_status(const Run& run, bool allow_undecided) {
  Concern worst = Concern::none;
  for (const FileRun& file : run.files) {
    for (const ClaimRun* claim : claims(file)) worst = std::max(worst, concern(*claim));
    if (!alarms_beside_claims(file).empty()) worst = Concern::alarm;
  }
  return status(worst, allow_undecided);
}

const char* word(Verdict verdict) {
  switch (verdict) {
    case Verdict::proven:
      return "proven";
    case Verdict::refuted:
      return "refuted";
    case Verdict::conditional:
      return "conditional";
    case Verdict::undecided:
      break;
  }
  return "undecided";
}

}  // namespace seam::report
