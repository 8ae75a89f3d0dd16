// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "prove/subdivide.h"

namespace seam::prove {

/// The coefficients show that form * side > 0 (strict) or >= 0 on the piece: none is negative;
/// and if strict, each face of the piece that is not outside the domain has a positive one
/// among its own. A face is outside, too, if one of the conditions has no coefficient there, or
/// coefficients of one sign alone, and that sign breaks it.
bool is_plain(const Factors&, const Piece&, const bernstein::Form&, int side, bool strict,
              const std::vector<Condition>& where = {});

/// The condition is broken all over the piece.
bool is_broken(const Factors&, const Piece&, const bernstein::Form&, certificate::Relation);

}  // namespace seam::prove
