// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/syntax.h"

#include <algorithm>

namespace seam::claims {

bool same(const Expression& a, const Expression& b) {
  return a.kind == b.kind && a.text == b.text &&
         std::ranges::equal(a.children, b.children, same);
}

}  // namespace seam::claims
