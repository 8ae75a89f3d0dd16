// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "certificate/evidence.h"

namespace seam::report {

/// A statement that was decided once.
struct TrialOutcome {
  certificate::Verdict verdict = certificate::Verdict::undecided;
  std::string reason;  ///< undecided: `time memory effort unsupported degenerate`
  std::string digest;  ///< of the statement; empty: unsupported
};

/// One small change of a file, and what a claim that rests on the place made of it.
struct MutantRun {
  enum class Fate {
    verdict,    ///< another verdict, on the claim or on its correction
    error,      ///< it cannot be read, or means nothing
    survived,   ///< the same verdicts, about another statement
    unchanged,  ///< the same statement: the change changes nothing that is checked
    unknown     ///< the time or the memory was over
  };
  std::string kind;           ///< of change: `number`, `sign`, …
  std::string file;           ///< in which it stands
  int line = 0, column = 0;   ///< where; from 1 on, in code points
  std::string before, after;  ///< what is changed, with what is round it
  Fate fate = Fate::unknown;
  TrialOutcome printed;
  std::optional<TrialOutcome> corrected;
  std::string error = {};  ///< the message
  std::string kept = {};   ///< the name of the file it was written to; empty: none
};

struct MutatedClaim {
  std::string id;
  TrialOutcome printed;  ///< unchanged
  std::optional<TrialOutcome> corrected;
  std::string why_not = {};  ///< not mutated: why
  bool is_error = false;     ///< it cannot be read
  std::vector<MutantRun> mutants;
};

/// How much the claims of a file notice.
struct MutationRun {
  std::string tool, file;
  std::uint64_t seed = 0;
  std::vector<MutatedClaim> claims;
};

/// `noticed` of `tried` mutants changed a verdict or could not be read; of the rest some
/// changed nothing that is checked. Those of which nothing is known are in none of these.
struct MutationScore {
  int noticed = 0, tried = 0, unchanged = 0, unknown = 0, errors = 0;
};
MutationScore score(const std::vector<MutantRun>&);

/// A line a claim with its score, each survivor below it, and a last line of all.
std::string mutation_text(const MutationRun&);
/// One JSON document with a final newline; no times in it.
std::string mutation_json(const MutationRun&);

}  // namespace seam::report
