// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/vocabulary.h"

namespace seam::cli {

/// The page seamproof(1) in mdoc: manual/seamproof.1 with the commands put in.
std::string manual(const std::vector<Command>&);

}  // namespace seam::cli
