// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace seam::report {

/// The file seamproof.sty: the macros of the report and of the papers that use parts of it.
extern const std::string_view style;

/// What stands before the style in the report: its paper, fonts and margins. With both, LaTeX
/// (Debian: texlive-latex-recommended, texlive-pictures, lmodern) needs no other file of ours.
extern const std::string_view preamble;

}  // namespace seam::report
