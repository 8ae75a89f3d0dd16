// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace seam::symbolic {

/// The libraries of this module and of those before it that are at work, with their versions:
/// `GiNaC 1.8.6`.
std::vector<std::string> libraries();

}  // namespace seam::symbolic
