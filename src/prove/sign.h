// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "prove/subdivide.h"

namespace seam::prove {

/// What a question came to: evidence for "yes", a place where the answer is "no", or neither.
struct Answer {
  enum class Kind { yes, no, neither };
  Kind kind = Kind::neither;
  certificate::Pieces pieces;            ///< yes
  Place place;                           ///< no
  exact::Sign sign = exact::Sign::zero;  ///< no: of f there
  certificate::Nothing nothing;          ///< neither
};

/// With so many pieces at most; those of the budget if not said.
Answer decide(Workshop&, Question, long effort);
Answer decide(Workshop&, Question);

/// A place as a point of the product.
certificate::Point write_point(Workshop&, const Factors&, const Place&);

}  // namespace seam::prove
