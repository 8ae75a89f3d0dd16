// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/run.h"

namespace seam::report {

/// Workflow commands of GitHub Actions, a line each, that put what is not as expected beside
/// its place in the file: errors, and warnings for undecided claims (notices with
/// `allow_undecided`). No text of a file can begin a command of its own.
std::string github_annotations(const Run&, bool allow_undecided);

/// The summary of a job in Markdown: counts, what is not as expected, all claims folded away.
std::string github_summary(const Run&);

}  // namespace seam::report
