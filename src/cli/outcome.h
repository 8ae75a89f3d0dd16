// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// Searches for evidence and hands it, with the statement, to the checker; the verdict is the
/// checker's. `alarm` is set where evidence was offered that the checker did not accept.
Decided decide(const claims::Lowered&, const claims::Expression& statement, const prove::Budget&);

}  // namespace seam::cli
