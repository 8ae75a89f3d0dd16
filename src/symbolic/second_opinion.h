// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "certificate/statement.h"

namespace seam::symbolic {

/// What an obligation that was accepted gives at one point of its domain, computed by CLN with
/// 100 digits: a sentence if that contradicts it, nothing if it agrees or has nothing to say.
///
/// Decides nothing: a contradiction is an alarm, agreement is no proof. Not thread-safe (GiNaC
/// is not).
std::optional<std::string> contradiction(const certificate::Statement&,
                                         const certificate::Obligation&);

}  // namespace seam::symbolic
