// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "report/run.h"

namespace seam::cli {

/// Whether `verify --out` wrote this folder.
bool has_results(const std::filesystem::path& folder);

/// What its results.json says, of one file. Throws `Failure` (65, 66).
report::Run results_in(const std::filesystem::path& folder);

}  // namespace seam::cli
