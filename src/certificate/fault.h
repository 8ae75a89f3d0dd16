// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include <string>
#include <string_view>

#include "certificate/evidence.h"

namespace seam::certificate {

/// No goal is nested deeper.
inline constexpr int max_goal_depth = 200;
/// No proof of a sign is nested deeper.
inline constexpr int max_proof_depth = 60;

/// `-?digits(/digits)?` without needless zeros, and not too long to be read as a number.
bool is_rational(std::string_view text);

/// What keeps statement and evidence from having a meaning, or nothing. Without a fault every
/// index points to something, operands to earlier nodes; lists that belong together are of
/// one length; constants and ends of intervals are rationals; there is one proof an obligation.
std::string fault(const Statement&, const Evidence&);

}  // namespace seam::certificate
