// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/run.h"

namespace seam::report {

/// Title, authors, what came of it in a sentence, and what was read by what.
std::string html_header(const FileRun&, const Run&);

/// The counts of each verdict, section by section.
std::string html_summary(const FileRun&);

/// The verdicts and the predicates that the claims use.
std::string html_glossary(const FileRun&);

/// `§6 Smooth Surfaces`: where the heading of a section stands, the n-th of the file.
std::string html_section_anchor(int number);

}  // namespace seam::report
