// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "exact/contract.h"
#include "exact/enclosures.h"
#include "exact/polynomial_body.h"
#include "exact/roots.h"

// Trager's method. Let K be the tower, h_1, ..., h_m its generators, s the number sum c_k h_k.
//
//   The norm N(x) of f(x - s) is the product over the conjugates of K; resultants with the
//   defining polynomials eliminate one generator after another. For all but finitely many s it
//   is squarefree, and then the irreducible factors of f over K are the gcd(f(x), N_i(x + s))
//   for the irreducible factors N_i of N over Q. The one that vanishes at a root r of f belongs
//   to the only N_i with N_i(r + s) = 0.

namespace seam::exact {

using flint::Arb;
using flint::Fmpz;
using flint::Mpoly;

namespace {

Polynomial shift_number(const RingPtr& ring, int attempt) {
  Polynomial s = ring->constant(0);
  const int variables = static_cast<int>(ring->variables().size());
  Rational weight = attempt;
  for (int k = 0; k < height(ring->tower()); ++k) {
    s = s + weight * ring->variable(variables + k);
    weight = weight * (attempt + 1) + 1;
  }
  return s;
}

// The norm down to Q of f(x - s), as an integer polynomial in x.
void norm(fmpz_poly_t result, const Univariate& f, int attempt) {
  const RingPtr ring = Ring::make(f.front().ring().tower(), {"x"});
  const Polynomial argument = ring->variable(0) - shift_number(ring, attempt);
  Polynomial shifted = ring->constant(0);
  for (int i = degree(f); i >= 0; --i) shifted = shifted * argument + ring->embed(f[i]);

  const Ring::Body& body = ring->body();
  const fmpz_mpoly_ctx_struct* context = body.integral();
  Mpoly eliminated(context);
  fmpz_mpoly_set(eliminated.it, shifted.body().it->zpoly, context);
  for (int k = static_cast<int>(body.generators.size()) - 1; k >= 0; --k) {
    Mpoly power(context), defining(context), term(context), next(context);
    const int symbol = body.position(k);
    for (int j = 0; j <= body.generators[k]->degree(); ++j) {
      fmpz_mpoly_gen(power.it, symbol, context);
      fmpz_mpoly_pow_ui(power.it, power.it, j, context);
      if (j == body.generators[k]->degree()) {
        fmpz_mpoly_add(defining.it, defining.it, power.it, context);
      } else {
        fmpz_mpoly_mul(term.it, power.it, body.tails[k][j].it, context);
        fmpz_mpoly_sub(defining.it, defining.it, term.it, context);
      }
    }
    const bool done =
        fmpz_mpoly_resultant(next.it, eliminated.it, defining.it, symbol, context) != 0;
    require(done, "irreducible_factor: the resultant is too large");
    eliminated = next;
  }
  require(fmpz_mpoly_get_fmpz_poly(result, eliminated.it, 0, context) != 0,
          "irreducible_factor: a generator is left");
  fmpz_poly_primitive_part(result, result);
}

bool may_vanish(const fmpz_poly_t f, const Arb& at, long precision) {
  Arb value;
  for (slong i = fmpz_poly_degree(f); i >= 0; --i) {
    arb_mul(value.it, value.it, at.it, precision);
    arb_add_fmpz(value.it, value.it, f->coeffs + i, precision);
  }
  return arb_contains_zero(value.it);
}

// The index of the only factor that vanishes at root + s.
slong vanishing(const fmpz_poly_factor_t factors, const Univariate& f, RootInterval root,
                const Polynomial& shift) {
  const auto numerators = shift.numerators();
  std::vector<slong> left(factors->num);
  for (slong i = 0; i < factors->num; ++i) left[i] = i;
  for (long precision = 64; left.size() > 1; precision *= 2) {
    Rational wanted = 1;
    mpq_div_2exp(wanted.get_mpq_t(), wanted.get_mpq_t(), precision);
    while (root.high - root.low > wanted) root = halved(f, root);
    const Arb low(root.low, 2 * precision), high(root.high, 2 * precision);
    Arb at;
    arb_union(at.it, low.it, high.it, 2 * precision);
    if (!numerators.terms.empty()) {
      const Arb s =
          evaluate(shift.ring().tower(), numerators.terms.begin()->second, 2 * precision);
      arb_add(at.it, at.it, s.it, 2 * precision);
    }
    std::erase_if(left,
                  [&](slong i) { return !may_vanish(factors->p + i, at, 2 * precision); });
  }
  require(left.size() == 1, "irreducible_factor: not a root");
  return left.front();
}

// g(x + s) mod f.
Univariate shifted_remainder(const fmpz_poly_t g, const Polynomial& s, const Univariate& f) {
  const Ring& ring = s.ring();
  const Univariate argument = {s, ring.constant(1)};
  Univariate result;
  for (slong i = fmpz_poly_degree(g); i >= 0; --i) {
    Fmpz c;
    fmpz_poly_get_coeff_fmpz(c.it, g, i);
    result = divide(result * argument, f).remainder;
    result = result + trimmed({ring.constant(flint::integer(c.it))});
  }
  return result;
}

}  // namespace

Univariate irreducible_factor(const Univariate& squarefree, RootInterval root) {
  const RingPtr ring = squarefree.front().body().ring;
  if (root.low == root.high) return {ring->constant(-root.low), ring->constant(1)};
  const Univariate f = monic(squarefree);
  if (degree(f) == 1) return f;
  fmpz_poly_t image;
  fmpz_poly_init(image);
  int attempt = 0;
  for (norm(image, f, attempt); !fmpz_poly_is_squarefree(image);) norm(image, f, ++attempt);
  fmpz_poly_factor_t factors;
  fmpz_poly_factor_init(factors);
  fmpz_poly_factor(factors, image);
  Univariate result = f;
  if (factors->num > 1) {
    const Polynomial s = shift_number(ring, attempt);
    const slong chosen = vanishing(factors, f, root, s);
    result = gcd(f, shifted_remainder(factors->p + chosen, s, f));
  }
  fmpz_poly_factor_clear(factors);
  fmpz_poly_clear(image);
  return result;
}

}  // namespace seam::exact
