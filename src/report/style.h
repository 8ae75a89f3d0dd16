// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace seam::report {

/// The LaTeX preamble of every report: packages of texlive-latex-recommended, lmodern and
/// texlive-pictures, and the macros that latex.cpp writes. A report is one file that needs no
/// other.
extern const std::string_view style;

}  // namespace seam::report
