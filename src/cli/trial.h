// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/verify.h"

namespace seam::cli {

/// One statement of a trial.
struct TrialStatement {
  report::Verdict verdict = report::Verdict::undecided;
  std::string reason;       ///< undecided: why, in a word
  std::string digest;       ///< of the statement; empty: unsupported
  std::string certificate;  ///< as text; empty: there is none, or it was not asked for
};

/// A claim of a text, and its correction, decided by themselves: what others it uses is not
/// looked at.
struct Trial {
  std::string error;                       ///< the first error of the text; empty: none
  std::vector<TrialStatement> statements;  ///< the claim, then its correction if it has one
};

/// A statement whose digest is among `known` is not decided; its verdict means nothing.
Trial try_claim(const std::string& text, const std::string& id, const VerifyOptions&,
                const std::vector<std::string>& known);

/// As one text, and back. `read_trial` takes what `write_trial` wrote.
std::string write_trial(const Trial&);
Trial read_trial(const std::string&);

}  // namespace seam::cli
