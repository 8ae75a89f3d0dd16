// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace seam::report {

/// What is wrong with markup as XML: an element that is not closed, or closed in the wrong
/// place, or a sign that must be escaped. Empty: nothing. (A whole page is read by an XML
/// parser in tests/page; this is for thousands of pieces.)
std::string not_well_formed(std::string_view markup);

}  // namespace seam::report
