// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/run.h"

namespace seam::report {

/// A run as JUnit XML, as CI systems read it: a test suite a file, a test case a claim. A claim
/// that was decided against expectation has failed, one that is undecided against expectation
/// too, or is skipped with `allow_undecided`; an alarm, or an error in the file, is an error.
/// The one format with times: it is for the run at hand, not to be kept.
std::string junit(const Run&, bool allow_undecided);

}  // namespace seam::report
