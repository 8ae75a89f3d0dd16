// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "claims/meaning.h"

namespace seam::claims {

/// The definitions, parameters, roots and sequences that a claim speaks of, those that these
/// speak of among them, in file order: all that a reader has to look up to know what it says.
std::vector<const Item*> rests_on(const Meaning&, const Claim&);

/// The same of any expressions, among these definitions.
std::vector<const Item*> rests_on(const std::vector<const Item*>& definitions,
                                  const std::vector<const Expression*>&);

}  // namespace seam::claims
