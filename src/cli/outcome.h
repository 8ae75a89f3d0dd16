// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "certificate/evidence.h"
#include "claims/meaning.h"
#include "prove/prove.h"
#include "report/run.h"

namespace seam::cli {

/// A statement proved or refuted, and judged.
struct Decided {
  report::Outcome outcome;
  certificate::Evidence evidence;
};

/// The normal form of a number of the file, for messages. Called from several threads.
using NormalForm = std::function<symbolic::Formula(const symbolic::Formula&)>;

/// Searches for evidence and hands it, with the statement, to the checker; the verdict is the
/// checker's. `alarm` is set where evidence was offered that the checker did not accept.
Decided decide(const claims::Lowered&, const claims::Expression& statement,
               const prove::Budget&, const NormalForm&);

}  // namespace seam::cli
