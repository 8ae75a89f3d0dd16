// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "cli/formulas.h"

namespace seam::cli {

/// What an identity or a sign says, read off the statement that was judged: the formula, its
/// relation, and all that its variables range over. Empty for other kinds.
std::string obligation_text(const certificate::Obligation&, Formulas&);

}  // namespace seam::cli
