// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "claims/layout.h"
#include "claims/syntax.h"

namespace seam::claims {

/// How tightly a kind of expression binds in text, loosest first. A child that binds looser
/// than its place wants stands in parentheses.
enum class Level {
  statement,  ///< quantifiers and `solve`, which reach as far right as they can
  equivalence,
  implication,
  disjunction,
  conjunction,
  negation,
  relation,
  range,
  prefix,  ///< `plane n d`, `curve from E`: these too reach far to the right
  sum,
  product,
  factor,
  power,
  postfix,
  callable  ///< what may stand in front of `(` or `[`
};

Level level(const Expression&);

/// The pieces of the canonical text of an expression, for a place that wants at least this
/// level.
std::vector<Piece> pieces(const Expression&, Level wanted);

}  // namespace seam::claims
