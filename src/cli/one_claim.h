// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cli/verify.h"

namespace seam::cli {

/// The one claim of a file, with everything it uses. Throws `Failure` (64) for an unknown id.
Verified one_claim(const std::string& file, const std::string& id, VerifyOptions);

const report::ClaimRun& find(const report::FileRun&, const std::string& id);

/// `holds`, `fails`, `open`.
const char* status_word(report::ObligationRun::Status);

}  // namespace seam::cli
