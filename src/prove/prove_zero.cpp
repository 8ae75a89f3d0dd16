// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "prove/strategies.h"

// A polynomial that is not 0 and of degree d in x stays not 0 at one of any d + 1 values of x.
// So variable after variable gets the first of 0, 1, 2, ... that leaves it not 0.

namespace seam::prove {

using exact::Polynomial;

certificate::Proof prove_by_computation() {
  return certificate::Computation{};
}

certificate::Proof prove_zero(Workshop& workshop, const certificate::Zero& zero) {
  const auto found = workshop.variables(zero.formula);
  std::vector<std::string> names(found.begin(), found.end());
  Polynomial f = workshop.expand(zero.formula, names);
  if (f.is_zero()) return certificate::Computation{};
  certificate::Witness witness;
  while (!names.empty()) {
    const std::vector<std::string> rest(names.begin(), names.end() - 1);
    const auto ring = workshop.ring(rest);
    std::vector<Polynomial> values;
    for (std::size_t i = 0; i < rest.size(); ++i)
      values.push_back(ring->variable(static_cast<int>(i)));
    long x = 0;
    for (;; ++x) {
      auto with_x = values;
      with_x.push_back(ring->constant(x));
      const Polynomial reduced = f.substitute(ring, with_x);
      if (reduced.is_zero()) continue;
      f = reduced;
      break;
    }
    witness.point.variables.push_back(names.back());
    witness.point.values.push_back(workshop.write(exact::Rational(x)));
    names = rest;
  }
  return witness;
}

}  // namespace seam::prove
