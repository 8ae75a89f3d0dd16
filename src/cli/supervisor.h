// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>

#include "claims/limits.h"
#include "cli/verify.h"

namespace seam::cli {

/// Runs a program in a process of its own, and returns its exit status; or ends by the signal
/// that ended it. Where a step of it (below) takes too much time or memory, or breaks off, the
/// program starts again from its beginning and leaves that step out; so nothing may be written
/// before the last step is done that a second start would not write over.
///
/// Always ends, if the program does without its steps: every start leaves out one more.
int supervised(const std::function<int()>& program);

/// The limits for the steps of one file. Each may take the time and memory of the options. A
/// step begins and ends in one thread, and holds no other. Without a supervisor there are no
/// limits.
claims::Limits limits(const VerifyOptions&, const std::string& file);

}  // namespace seam::cli
