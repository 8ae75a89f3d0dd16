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

bool decided(const Outcome& outcome) {
  return outcome.verdict == Verdict::proven || outcome.verdict == Verdict::refuted;
}

// The status of one claim alone; of several, the more urgent counts.
int status(const ClaimRun& claim, bool allow_undecided) {
  if (!claim.printed.alarm.empty() || (claim.corrected && !claim.corrected->alarm.empty()))
    return 3;
  if (as_expected(claim)) return 0;
  if (decided(claim.printed) && claim.printed.verdict != claim.expected) return 1;
  if (claim.corrected && claim.corrected->verdict == Verdict::refuted) return 1;
  return allow_undecided ? 0 : 2;
}

int urgency(int status) {
  return status == 3 ? 3 : status == 1 ? 2 : status == 2 ? 1 : 0;
}

}  // namespace

std::vector<const ClaimRun*> claims(const FileRun& file) {
  std::vector<const ClaimRun*> found;
  for (const ItemRun& item : file.items) {
    if (const auto* claim = std::get_if<ClaimRun>(&item)) found.push_back(claim);
    if (const auto* table = std::get_if<TableRun>(&item))
      for (const TableRun::Row& row : table->rows)
        for (const ClaimRun& cell : row.cells) found.push_back(&cell);
  }
  return found;
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

int exit_status(const Run& run, bool allow_undecided) {
  int worst = 0;
  for (const FileRun& file : run.files)
    for (const ClaimRun* claim : claims(file))
      worst = std::max(worst, status(*claim, allow_undecided),
                       [](int a, int b) { return urgency(a) < urgency(b); });
  return worst;
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
