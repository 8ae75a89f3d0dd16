// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/conjunction.h"

#include <algorithm>

namespace seam::claims {

using symbolic::Proposition;

bool is_conjunction(const Proposition& p) {
  return p.kind == Proposition::Kind::atom ||
         (p.kind == Proposition::Kind::all && std::ranges::all_of(p.parts, is_conjunction));
}

}  // namespace seam::claims
