// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "certificate/evidence.h"
#include "certificate/layout.h"

namespace seam::tampered {

/// A certificate as it is, judged.
struct Original {
  std::string file;
  certificate::Json json;
  certificate::Statement statement;
  std::string digest;
  certificate::Verdict verdict = certificate::Verdict::undecided;  ///< that the evidence shows
};

/// What came of a changed certificate.
struct Outcome {
  enum class Kind {
    unchanged,        ///< the change changed nothing
    unreadable,       ///< no certificate
    rejected,         ///< the evidence does not show the verdict
    same_statement,   ///< accepted: other evidence for the statement as it was
    other_statement,  ///< accepted, with another digest: true, or the checker is wrong
    wrong             ///< certainly wrong: see `reason`
  };
  Kind kind = Kind::unchanged;
  std::string reason;
  /// What the evidence shows, whatever the certificate says: a second judge is asked.
  certificate::Verdict shown = certificate::Verdict::undecided;
};

Original original(const std::string& file);
Outcome outcome(const Original&, const certificate::Json& changed);

}  // namespace seam::tampered
