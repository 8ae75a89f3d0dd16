// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "report/run.h"

namespace seam::report {

/// Parts of the report for papers to input, by file name: `a.smooth.tex` for the claim
/// a.smooth, `tables/t.tex`, `figures/1.tex`; seamproof-status.tex with every verdict; and
/// seamproof.sty, which is all that a paper needs to typeset them.
std::map<std::string, std::string> fragments(const FileRun&);

}  // namespace seam::report
