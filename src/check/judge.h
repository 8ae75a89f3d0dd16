// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include <string>
#include <vector>

#include "certificate/evidence.h"

namespace seam::check {

/// What evidence shows of one obligation.
struct Finding {
  enum class Kind { holds, fails, open };
  Kind kind = Kind::open;
  std::string reason;  ///< for `open`: why the evidence shows nothing; for `fails`: where it
                       ///< does, if that is a place in a mesh
};

struct Judgement {
  certificate::Verdict verdict =
      certificate::Verdict::undecided;  ///< never `conditional`: that is for who knows the
                                        ///< other claims
  std::vector<Finding> findings;        ///< one an obligation
  std::string reason;                   ///< for `undecided`: the first reason that matters
};

/// Judges a statement by its evidence, with nothing but integers and rationals of its own.
///
/// `proven` implies that the statement is true, `refuted` that it is false. Any statement and
/// any evidence may be passed in: it always ends, within `effort` elementary steps.
[[nodiscard]] Judgement judge(const certificate::Statement&, const certificate::Evidence&,
                              long effort = 2'000'000'000);

}  // namespace seam::check
