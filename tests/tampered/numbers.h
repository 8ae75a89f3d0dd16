// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace seam::tampered {

/// Whether the text is a rational as certificates have them.
bool is_number(const std::string& text);
std::string negated(const std::string& number);
/// The numbers that are 1 and 10^-9 away, in lowest terms.
std::vector<std::string> nearby(const std::string& number);
/// The number with its first, its middle or its last digit one higher; none starts with 0.
std::vector<std::string> with_other_digits(const std::string& number);

}  // namespace seam::tampered
