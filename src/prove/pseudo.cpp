// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/pseudo.h"

#include "exact/field.h"

// Each round takes the highest power of the variable out of the remainder; it ends because the
// degree goes down.

namespace seam::prove {

using exact::Polynomial;

Polynomial initial(const Polynomial& f, int variable) {
  return f.coefficients({variable}).rbegin()->second;
}

PseudoDivision pseudo_divide(const Equations& stated, const Polynomial& a, const Polynomial& b,
                             int variable) {
  const exact::Ring& ring = a.ring();
  const int degree = b.degree(variable);
  const Polynomial lead = initial(b, variable);
  const bool is_number = lead.is_number();
  const Polynomial factor = is_number ? exact::inverse(lead) : ring.constant(1);
  PseudoDivision result{0, ring.constant(0), a};
  while (result.remainder.degree(variable) >= degree) {
    const int excess = result.remainder.degree(variable) - degree;
    const Polynomial term =
        factor * initial(result.remainder, variable) * ring.variable(variable).pow(excess);
    if (!is_number) {
      ++result.power;
      result.quotient = stated.reduced(lead * result.quotient);
      result.remainder = lead * result.remainder;
    }
    result.quotient = result.quotient + term;
    result.remainder = stated.reduced(result.remainder - term * b);
  }
  return result;
}

}  // namespace seam::prove
