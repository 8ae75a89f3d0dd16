// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "exact/factors.h"
#include "exact/roots.h"
#include "prove/eliminate.h"
#include "prove/pseudo.h"

// Over the rationals factors are found as they are. Over a tower they may be products still:
// what is claimed to be a solution gives linear factors to try, and a polynomial in one
// variable is split at its real roots. Each round replaces a base by ones of lower degree, so
// it ends.

namespace seam::prove {

using exact::Polynomial;
using exact::Univariate;

namespace {

constexpr std::size_t most_terms = 4000;

class Splitting {
 public:
  Splitting(const Equations& stated, Polynomial multiplier)
      : stated_(stated), result_{std::move(multiplier), {}} {}

  void add(const Polynomial& base, int exponent) {
    if (base.is_number()) {
      result_.multiplier = result_.multiplier * exact::inverse(base).pow(exponent);
      return;
    }
    if ((base.ring().tower() || !stated_.functions.empty()) &&
        (by_solution(base, exponent) || by_roots(base, exponent)))
      return;
    const auto same = std::ranges::find_if(
        result_.powers, [&](const Power& power) { return power.base == base; });
    if (same != result_.powers.end())
      same->exponent += exponent;
    else
      result_.powers.push_back({base, exponent});
  }

  Product result() && { return std::move(result_); }

 private:
  bool by_solution(const Polynomial& base, int exponent) {
    for (const auto& solution : stated_.solutions)
      for (std::size_t j = 0; j < solution.size(); ++j) {
        const int variable = stated_.unknowns[j];
        if (solution[j].degree(variable) != 1 || base.degree(variable) < 2) continue;
        const auto [power, quotient, remainder] =
            pseudo_divide(stated_, base, solution[j], variable);
        if (!remainder.is_zero()) continue;
        result_.multiplier =
            result_.multiplier * initial(solution[j], variable).pow(power * exponent);
        add(solution[j], exponent);
        add(quotient, exponent);
        return true;
      }
    return false;
  }

  bool by_roots(const Polynomial& base, int exponent) {
    int variable = -1;
    for (int v = 0; v < std::ssize(base.ring().variables()); ++v)
      if (base.degree(v) > 0) {
        if (variable >= 0) return false;
        variable = v;
      }
    if (base.degree(variable) < 2) return false;
    const exact::RingPtr numbers = exact::Ring::make(base.ring().tower(), {});
    Univariate f;
    for (const Polynomial& c : exact::univariate(base, variable))
      f.push_back(numbers->embed(c));
    const Univariate simple = exact::squarefree(f);
    for (const auto& root : exact::real_roots(simple)) {
      const Univariate factor = exact::irreducible_factor(simple, root);
      if (exact::degree(factor) == exact::degree(f)) continue;
      add(polynomial(factor, base, variable), exponent);
      add(polynomial(exact::divide(f, factor).quotient, base, variable), exponent);
      return true;
    }
    return false;
  }

  static Polynomial polynomial(const Univariate& f, const Polynomial& like, int variable) {
    const exact::Ring& ring = like.ring();
    Polynomial sum = ring.constant(0);
    for (int i = 0; i <= exact::degree(f); ++i)
      sum = sum + ring.embed(f[i]) * ring.variable(variable).pow(i);
    return sum;
  }

  const Equations& stated_;
  Product result_;
};

}  // namespace

Product factored(const Polynomial& f, const Equations& stated) {
  if (f.numerators().terms.size() > most_terms) return {f.ring().constant(1), {{f, 1}}};
  const exact::Factors found = exact::factors(f);
  Splitting splitting(stated, exact::inverse(found.number));
  for (const auto& [base, exponent] : found.factors) splitting.add(base, exponent);
  return std::move(splitting).result();
}

}  // namespace seam::prove
