// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>

#include "certificate/evidence.h"

namespace seam::prove {

struct Budget {
  long effort = 20'000;  ///< pieces a subdivision may have before it is given up
  std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
};

/// Searches for evidence, one proof an obligation: evidence that the obligation holds, or
/// evidence that it fails, or `Nothing` with the reason. May be wrong: whoever calls it hands
/// the result to seam::check.
///
/// Deterministic unless the deadline is met. Obligations already settled the goal are still
/// tried, except those that can no longer matter.
[[nodiscard]] certificate::Evidence prove(const certificate::Statement&, const Budget& = {});

}  // namespace seam::prove
