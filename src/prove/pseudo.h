// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "prove/equations.h"

namespace seam::prove {

/// The coefficient of the highest power of a variable.
exact::Polynomial initial(const exact::Polynomial&, int variable);

/// initial(b)^power * a = quotient * b + remainder, the remainder of lower degree than b in the
/// variable, up to what functions are. Where the initial is a number the power is 0.
struct PseudoDivision {
  int power = 0;
  exact::Polynomial quotient, remainder;
};
/// Requires that b holds the variable.
PseudoDivision pseudo_divide(const Equations&, const exact::Polynomial& a,
                             const exact::Polynomial& b, int variable);

}  // namespace seam::prove
