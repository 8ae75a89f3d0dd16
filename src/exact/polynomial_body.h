// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "exact/flint.h"
#include "exact/polynomial.h"

namespace seam::exact {

/// The context's symbols: the variables, then the generators from the lowest on.
struct Ring::Body {
  TowerPtr tower;
  std::vector<const Tower*> generators;
  std::vector<std::string> variables;
  fmpq_mpoly_ctx_t context;
  /// tails[k][j]: of generator k, h^degree = sum tails[k][j] h^j.
  std::vector<std::vector<flint::Mpoly>> tails;

  const fmpz_mpoly_ctx_struct* integral() const { return context->zctx; }
  int symbols() const { return static_cast<int>(variables.size() + generators.size()); }
  int position(int generator) const { return static_cast<int>(variables.size()) + generator; }

  Body(TowerPtr, std::vector<std::string>);
  ~Body();
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;
};

struct Polynomial::Body {
  RingPtr ring;
  fmpq_mpoly_t it;

  explicit Body(RingPtr r) : ring(std::move(r)) { fmpq_mpoly_init(it, context()); }
  ~Body() { fmpq_mpoly_clear(it, context()); }
  Body(const Body&) = delete;
  Body& operator=(const Body&) = delete;
  const fmpq_mpoly_ctx_struct* context() const { return ring->body().context; }
};

/// Adds coordinates * (monomial of variables) to `sum`, unsorted.
void push_terms(flint::Mpoly& sum, const Ring::Body&, const Coordinates&, const Exponents&);

}  // namespace seam::exact
