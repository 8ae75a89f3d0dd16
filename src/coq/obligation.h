// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "certificate/evidence.h"

namespace seam::coq {

/// What is known of an obligation whose evidence is to compute and see.
enum class Shown { holds, fails, open };

/// An obligation as a theorem with its proof, or why there is none.
struct Theorem {
  std::string text;      ///< empty: none
  std::string kind;      ///< `zero`, `sign`, `mesh` ...
  std::string left_out;  ///< why there is none
};

/// A theorem of that name, which says in terms of Coq's real numbers what the obligation says,
/// or that it fails at a point.
Theorem write_theorem(const certificate::Certificate&, std::size_t obligation, Shown,
                      const std::string& name);

}  // namespace seam::coq
