// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <set>
#include <string>

#include "cli/verify.h"

namespace seam::cli {

/// Removes what a run that was killed left half written in the folder and those below it.
void remove_unfinished(const std::filesystem::path& folder);

/// Removes the certificates in the folder of claims that are no longer in the file. Does
/// nothing where only a selection of the claims was verified.
void remove_vanished(const std::filesystem::path& folder, const Verified&);

/// Removes what an earlier run left of report.html, report.pdf, fragments/ and figures/ and
/// this one did not write (paths below the folder): it would contradict the results beside it.
void remove_outdated(const std::filesystem::path& folder, const std::set<std::string>& written);

}  // namespace seam::cli
