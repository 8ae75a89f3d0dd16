// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace seam::exact {

/// The libraries of this module that are at work, with their versions: `FLINT 2.9.0`.
std::vector<std::string> libraries();

}  // namespace seam::exact
