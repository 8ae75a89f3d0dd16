// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "report/mutation_run.h"
#include "report/run.h"

namespace seam::report {
namespace {

using Fate = MutantRun::Fate;

std::string verdicts(const MutatedClaim& claim) {
  std::string text = word(claim.printed.verdict);
  if (claim.corrected) text += std::string(", corrected ") + word(claim.corrected->verdict);
  return text;
}

std::string of_all(const MutationScore& score) {
  return std::to_string(score.noticed) + " of " + std::to_string(score.tried) + " noticed";
}

std::string survivor(const MutatedClaim& claim, const MutantRun& mutant) {
  return "    " + mutant.file + ":" + std::to_string(mutant.line) + ":" +
         std::to_string(mutant.column) + "  " + mutant.kind + "\n      - " + mutant.before +
         "\n      + " + mutant.after + "\n      " +
         (mutant.fate == Fate::unchanged ? "changes nothing that is checked"
                                         : "another statement, still " + verdicts(claim)) +
         "\n";
}

}  // namespace

MutationScore score(const std::vector<MutantRun>& mutants) {
  MutationScore result;
  for (const MutantRun& mutant : mutants) {
    if (mutant.fate == Fate::unknown) {
      ++result.unknown;
      continue;
    }
    ++result.tried;
    if (mutant.fate == Fate::unchanged) ++result.unchanged;
    if (mutant.fate == Fate::error) ++result.errors;
    if (mutant.fate == Fate::error || mutant.fate == Fate::verdict) ++result.noticed;
  }
  return result;
}

std::string mutation_text(const MutationRun& run) {
  std::string text;
  std::vector<MutantRun> all;
  int mutated = 0;
  for (const MutatedClaim& claim : run.claims) {
    if (claim.mutants.empty()) {
      if (!claim.why_not.empty()) text += claim.id + "  not mutated: " + claim.why_not + "\n";
      continue;
    }
    ++mutated;
    const MutationScore own = score(claim.mutants);
    text += claim.id + "  " + of_all(own);
    if (own.unknown > 0) text += ", " + std::to_string(own.unknown) + " took too long";
    text += "\n";
    for (const MutantRun& mutant : claim.mutants)
      if (mutant.fate == Fate::survived || mutant.fate == Fate::unchanged)
        text += survivor(claim, mutant);
    all.insert(all.end(), claim.mutants.begin(), claim.mutants.end());
  }
  const MutationScore sum = score(all);
  const auto number = [](int n) { return std::to_string(n); };
  return text + number(mutated) + (mutated == 1 ? " claim, " : " claims, ") +
         number(static_cast<int>(all.size())) +
         " mutants: " + number(sum.noticed - sum.errors) + " changed a verdict, " +
         number(sum.errors) + " could not be read, " +
         number(sum.tried - sum.noticed - sum.unchanged) +
         " survived with another statement, " + number(sum.unchanged) +
         " changed nothing that is checked, " + number(sum.unknown) + " took too long; seed " +
         std::to_string(run.seed) + "\n";
}

}  // namespace seam::report
