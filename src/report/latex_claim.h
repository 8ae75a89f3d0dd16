// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/run.h"

namespace seam::report {

/// A claim as the report shows it: its statement, verdict, witness or reason, correction, what
/// it was turned into, and where its certificate lies.
std::string latex_claim(const ClaimRun&);

/// The id of a claim, which leads to it.
std::string latex_claim_link(const ClaimRun&);

/// The name that a link to the claim goes by.
std::string latex_anchor(const ClaimRun&);

}  // namespace seam::report
