// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace seam::report {

/// A witness with the signs that a reader is used to: `√2 ≠ 0` for `sqrt(2) != 0`.
std::string readable_witness(const std::string& witness);

}  // namespace seam::report
