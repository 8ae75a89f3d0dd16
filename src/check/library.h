// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include <string>

namespace seam::check {

/// The one library whose arithmetic the checker uses, with its version: `Boost 1.74.0`.
std::string library();

}  // namespace seam::check
