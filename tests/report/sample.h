// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "report/run.h"

namespace seam::report {

/// A run with one of everything: each verdict, a correction, a table, a figure, questions,
/// formulas that are too long for a line, and text that would break a document if it were not
/// escaped.
Run sample();

}  // namespace seam::report
