// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/run.h"

namespace seam::report {

/// The report of a run as one LaTeX document (see style.h for what it needs): a summary, the
/// errata, then every item of the files in order, and a glossary. Equal runs give equal bytes:
/// no times. No text of a file can break the document or do more than be printed.
std::string latex(const Run&);

}  // namespace seam::report
