// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace seam::report {

/// Mathematics that can be printed without harm: only commands and environments known to be
/// harmless; braces, environments and \left ... \right nested properly; no character that would
/// end the formula.
bool is_plain_mathematics(std::string_view latex);

/// The formula if it is plain mathematics; else its source as text. Either goes between dollar
/// signs. So no formula can break the report or do more than be printed.
std::string mathematics(std::string_view latex);

}  // namespace seam::report
