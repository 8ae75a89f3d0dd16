// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "report/run.h"

namespace seam::report {

/// Mathematics as MathML in a box of its own, or its source where it is no plain mathematics.
std::string html_formula(const std::string& latex);

/// The same within a line.
std::string html_inline(const std::string& latex);

/// `✓ proven`, coloured; the shape is hidden from readers of screens.
std::string html_verdict(Verdict);

/// The same as a shape alone, its word for readers of screens.
std::string html_mark(Verdict);

/// Text in the letters of a program, or nothing.
std::string html_code(const std::string& text);

/// What refutes a claim, with the signs of mathematics, or nothing.
std::string html_witness(const std::string& witness);

/// Markup, with commas between what is not empty.
std::string html_list(const std::vector<std::string>& parts);

/// A section of the page with its heading, or nothing where it has no content.
std::string html_section(const std::string& anchor, const std::string& title,
                         const std::string& content);

/// The comments above an item, what stands between backticks as a program, or nothing.
std::string html_note(const std::vector<std::string>& comments);

/// Where a claim stands in the page: `claim:a.smooth`.
std::string html_anchor(const std::string& id);

/// A link to a claim, by its id.
std::string html_link(const std::string& id);

/// Rows of a list of terms, each with what it stands for; those without are left out.
struct Term {
  std::string name, content;  ///< text; markup
};
std::string html_terms(const std::vector<Term>&);

}  // namespace seam::report
