// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace seam::report {

/// Any bytes as text of an XML or HTML element or of an attribute in double quotes: well-formed
/// UTF-8 in which only characters that XML allows stand; each other byte or character is shown
/// as U+FFFD, a control character by its picture (`␀`). Nothing in it is read as markup.
std::string html_escape(std::string_view text);

/// `<p class="note">content</p>` of `p class="note"`: the one place where elements are written,
/// so that each is closed. `content` is markup.
std::string html_element(std::string_view tag_and_attributes, const std::string& content);

}  // namespace seam::report
