// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/run.h"

namespace seam::report {

/// What is not as expected in a run, as SARIF 2.1.0 (OASIS): a result with its place for each
/// claim decided or left undecided against expectation, each alarm, each error in a file. What
/// is as expected is no result, since viewers show every result as something to look at.
/// Undecided claims are warnings; with `allow_undecided` they are of the kind `open`, without a
/// level. Equal runs give equal bytes.
std::string sarif(const Run&, bool allow_undecided);

}  // namespace seam::report
