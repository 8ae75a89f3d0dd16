// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace seam::report {

/// `\macro{argument}{...}` on a line of its own.
std::string latex_call(const std::string& macro, const std::vector<std::string>& arguments);

std::string latex_heading(const std::string& title);

/// The comment lines of a file as one remark; empty for none.
std::string latex_note(const std::vector<std::string>& comments);

/// The parts that are not empty, with the separator between them.
std::string joined(const std::vector<std::string>& parts, const std::string& separator);

}  // namespace seam::report
