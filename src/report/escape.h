// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace seam::report {

/// Any text as LaTeX that prints it: characters known to be harmless pass, some have a macro,
/// any other is printed by its number, `[U+4E2D]`. Long words may be broken. Any bytes may be
/// passed in.
std::string escape(std::string_view text);

}  // namespace seam::report
