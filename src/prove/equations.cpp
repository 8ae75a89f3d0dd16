// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/equations.h"

#include <utility>

// From the last function to the first: a radicand holds earlier ones alone.

namespace seam::prove {

using exact::Polynomial;

int Equations::first_function() const {
  return static_cast<int>(variables(factors).size() + unbounded.size());
}

bool Equations::holds_function(const Polynomial& f) const {
  for (std::size_t k = 0; k < functions.size(); ++k)
    if (f.degree(first_function() + static_cast<int>(k)) > 0) return true;
  return false;
}

Polynomial Equations::reduced(Polynomial f) const {
  for (std::size_t k = functions.size(); k-- > 0;) {
    const int place = first_function() + static_cast<int>(k);
    const int degree = functions[k]->degree;
    while (f.degree(place) >= degree) {
      const Polynomial symbol = f.ring().variable(place);
      Polynomial sum = f.ring().constant(0);
      for (const auto& [exponents, coefficient] : f.coefficients({place})) {
        const int e = exponents.front();
        sum = sum + (e < degree ? coefficient * symbol.pow(e)
                                : coefficient * radicands[k] * symbol.pow(e - degree));
      }
      f = sum;
    }
  }
  return f;
}

}  // namespace seam::prove
