// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "claims/meaning.h"
#include "report/run.h"

namespace seam::cli {

/// What in a file may be a slip, though nothing in it is wrong: each is certain to be as it
/// says. They change no verdict.
std::vector<report::WarningRun> warnings_of(const std::filesystem::path&,
                                            const claims::Meaning&, const report::FileRun&);

}  // namespace seam::cli
