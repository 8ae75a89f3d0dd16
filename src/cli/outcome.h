// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "certificate/evidence.h"
#include "claims/meaning.h"
#include "report/run.h"

namespace seam::cli {

/// A statement judged by evidence.
struct Decided {
  enum class Origin { searched, stored };
  report::Outcome outcome;
  certificate::Evidence evidence;
  Origin origin = Origin::searched;
  double seconds = 0;
};

/// The normal form of a number of the file, for messages. Called from several threads.
using NormalForm = std::function<symbolic::Formula(const symbolic::Formula&)>;

/// Hands the evidence, with the statement, to the checker; the verdict is the checker's.
/// `alarm` is set where evidence was offered that the checker did not accept.
Decided judged(const claims::Lowered&, const claims::Expression& statement,
               certificate::Evidence, const NormalForm&);

/// Undecided with that reason: the checker was not asked, or did not end in time. Of a
/// statement with obligations.
Decided not_judged(const claims::Lowered&, const claims::Expression& statement,
                   const claims::Refusal&);

/// For each obligation nothing, and why.
certificate::Evidence no_evidence(const certificate::Statement&, const std::string& reason,
                                  const std::string& detail);

}  // namespace seam::cli
