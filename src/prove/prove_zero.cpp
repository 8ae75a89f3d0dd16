// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "prove/derive.h"
#include "prove/strategies.h"

// A polynomial that is not 0 and of degree d in x stays not 0 at one of any d + 1 values of x.
// So variable after variable gets the first of 0, 1, 2, ... that leaves it not 0. With
// functions, points at which these have simple values are tried.

namespace seam::prove {

using exact::Polynomial;

certificate::Proof prove_by_computation() {
  return certificate::Computation{};
}

namespace {

certificate::Proof refute_among_functions(
    Workshop& workshop, const std::vector<std::string>& names,
    const std::vector<const certificate::Function*>& functions, const Polynomial& f) {
  const auto numbers = workshop.numbers();
  Factors factors;
  for (std::size_t i = 0; i + functions.size() < names.size(); ++i)
    factors.push_back({{names[i]},
                       {{numbers->constant(1), numbers->constant(-16)},
                        {numbers->constant(1), numbers->constant(16)}},
                       {false, false},
                       0});
  Derivation derivation(workshop, make_region(workshop, std::move(factors), {}, functions));
  if (auto point = derivation.refute(f, certificate::Relation::zero))
    return certificate::Witness{*point, {}};
  return certificate::Nothing{"effort", "neither an identity nor refuted by a simple point"};
}

}  // namespace

certificate::Proof prove_zero(Workshop& workshop, const certificate::Zero& zero) {
  const auto found = workshop.variables(zero.formula);
  const auto functions = workshop.functions({zero.formula});
  std::vector<std::string> names(found.begin(), found.end());
  for (const auto* function : functions) names.push_back(function->name);
  std::vector<std::string> all = names;
  all.insert(all.end(), workshop.transcendental().begin(), workshop.transcendental().end());
  if (workshop.expand(zero.formula, all).is_zero()) return certificate::Computation{};
  Polynomial f = workshop.expand(zero.formula, names);
  if (f.is_zero()) return certificate::Nothing{"effort", "a number that is not told from 0"};
  if (!functions.empty()) return refute_among_functions(workshop, names, functions, f);
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
