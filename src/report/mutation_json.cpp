// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/json_writer.h"
#include "report/mutation_run.h"
#include "report/run.h"

namespace seam::report {
namespace {

Json json_of(const TrialOutcome& outcome) {
  Json object = {{"verdict", word(outcome.verdict)}};
  if (!outcome.reason.empty()) object["reason"] = json_text(outcome.reason);
  if (!outcome.digest.empty()) object["digest"] = outcome.digest;
  return object;
}

Json json_of(const MutantRun& mutant) {
  static constexpr const char* fates[] = {"verdict", "error", "survived", "unchanged",
                                          "unknown"};
  Json object = {{"kind", mutant.kind},
                 {"file", json_text(mutant.file)},
                 {"line", mutant.line},
                 {"column", mutant.column},
                 {"before", json_text(mutant.before)},
                 {"after", json_text(mutant.after)},
                 {"fate", fates[static_cast<int>(mutant.fate)]},
                 {"printed", json_of(mutant.printed)}};
  if (mutant.corrected) object["corrected"] = json_of(*mutant.corrected);
  if (!mutant.error.empty()) object["error"] = json_text(mutant.error);
  if (!mutant.kept.empty()) object["kept"] = json_text(mutant.kept);
  return object;
}

Json json_of(const MutatedClaim& claim) {
  const MutationScore own = score(claim.mutants);
  Json object = {{"id", claim.id}, {"printed", json_of(claim.printed)}};
  if (claim.corrected) object["corrected"] = json_of(*claim.corrected);
  object["noticed"] = own.noticed;
  object["tried"] = own.tried;
  object["unchanged"] = own.unchanged;
  object["unknown"] = own.unknown;
  if (!claim.why_not.empty()) object["not_mutated"] = json_text(claim.why_not);
  object["mutants"] = Json::array();
  for (const MutantRun& mutant : claim.mutants) object["mutants"].push_back(json_of(mutant));
  return object;
}

}  // namespace

std::string mutation_json(const MutationRun& run) {
  Json object = {{"schema_version", 1},
                 {"tool", run.tool},
                 {"file", json_text(run.file)},
                 {"seed", run.seed},
                 {"claims", Json::array()}};
  for (const MutatedClaim& claim : run.claims) object["claims"].push_back(json_of(claim));
  return object.dump(1) + "\n";
}

}  // namespace seam::report
