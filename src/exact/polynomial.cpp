// SPDX-License-Identifier: GPL-3.0-or-later
#include "exact/polynomial.h"

#include <algorithm>
#include <utility>

#include "exact/contract.h"
#include "exact/polynomial_body.h"

// Polynomials are integer polynomials in (variables, generators) with one rational in front; no
// arithmetic is ever done coefficient by coefficient in the number field.
//
// Reduction goes from the highest generator down, so each is reduced once: the tail of a
// generator holds only lower ones.

namespace seam::exact {

using flint::Mpoly;
using Built = std::shared_ptr<Polynomial::Body>;

namespace {

Built build(const Polynomial& like) {
  return std::make_shared<Polynomial::Body>(like.body().ring);
}

// a, as coefficients of powers of one symbol.
std::vector<Mpoly> split(const fmpz_mpoly_t a, int symbol,
                         const fmpz_mpoly_ctx_struct* context) {
  std::vector<Mpoly> result(fmpz_mpoly_degree_si(a, symbol, context) + 1, Mpoly(context));
  fmpz_mpoly_univar_t parts;
  fmpz_mpoly_univar_init(parts, context);
  fmpz_mpoly_to_univar(parts, a, symbol, context);
  for (slong i = 0; i < fmpz_mpoly_univar_length(parts, context); ++i) {
    const slong exponent = fmpz_mpoly_univar_get_term_exp_si(parts, i, context);
    fmpz_mpoly_univar_swap_term_coeff(result[exponent].it, parts, i, context);
  }
  fmpz_mpoly_univar_clear(parts, context);
  return result;
}

void reduce_by(fmpz_mpoly_t a, int symbol, const std::vector<Mpoly>& tail,
               const fmpz_mpoly_ctx_struct* context) {
  const int degree = static_cast<int>(tail.size());
  if (fmpz_mpoly_degree_si(a, symbol, context) < degree) return;
  auto parts = split(a, symbol, context);
  Mpoly product(context), power(context);
  for (int i = static_cast<int>(parts.size()) - 1; i >= degree; --i)
    for (int j = 0; j < degree; ++j) {
      if (fmpz_mpoly_is_zero(tail[j].it, context)) continue;
      fmpz_mpoly_mul(product.it, parts[i].it, tail[j].it, context);
      Mpoly& into = parts[i - degree + j];
      fmpz_mpoly_add(into.it, into.it, product.it, context);
    }
  fmpz_mpoly_swap(a, parts[0].it, context);
  for (int j = 1; j < degree; ++j) {
    fmpz_mpoly_gen(power.it, symbol, context);
    fmpz_mpoly_pow_ui(power.it, power.it, j, context);
    fmpz_mpoly_mul(product.it, parts[j].it, power.it, context);
    fmpz_mpoly_add(a, a, product.it, context);
  }
}

Polynomial reduced(Built value) {
  const Ring::Body& ring = value->ring->body();
  for (int k = static_cast<int>(ring.generators.size()) - 1; k >= 0; --k)
    reduce_by(value->it->zpoly, ring.position(k), ring.tails[k], ring.integral());
  fmpq_mpoly_reduce(value->it, ring.context);
  return Polynomial(std::move(value));
}

void same_ring(const Polynomial& a, const Polynomial& b) {
  require(&a.ring() == &b.ring() || (a.ring().tower() == b.ring().tower() &&
                                     a.ring().variables() == b.ring().variables()),
          "Polynomial: elements of different rings");
}

}  // namespace

const Ring& Polynomial::ring() const {
  return *body_->ring;
}

bool Polynomial::is_zero() const {
  return fmpq_mpoly_is_zero(body_->it, body_->context());
}

bool Polynomial::is_number() const {
  for (std::size_t i = 0; i < ring().variables().size(); ++i)
    if (degree(static_cast<int>(i)) > 0) return false;
  return true;
}

std::optional<Rational> Polynomial::rational() const {
  if (!fmpq_mpoly_is_fmpq(body_->it, body_->context())) return std::nullopt;
  flint::Fmpq value;
  fmpq_mpoly_get_fmpq(value.it, body_->it, body_->context());
  return flint::rational(value.it);
}

int Polynomial::degree(int variable) const {
  return static_cast<int>(fmpq_mpoly_degree_si(body_->it, variable, body_->context()));
}

int Polynomial::degree(const std::vector<int>& variables) const {
  const Ring::Body& r = ring().body();
  std::vector<ulong> exponents(std::max(1, r.symbols()));
  int result = -1;
  for (slong i = 0; i < fmpz_mpoly_length(body_->it->zpoly, r.integral()); ++i) {
    fmpz_mpoly_get_term_exp_ui(exponents.data(), body_->it->zpoly, i, r.integral());
    int total = 0;
    for (const int v : variables) total += static_cast<int>(exponents[v]);
    result = std::max(result, total);
  }
  return result;
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) {
  same_ring(a, b);
  const Built result = build(a);
  fmpq_mpoly_add(result->it, a.body_->it, b.body_->it, result->context());
  return Polynomial(result);
}

Polynomial operator-(const Polynomial& a, const Polynomial& b) {
  same_ring(a, b);
  const Built result = build(a);
  fmpq_mpoly_sub(result->it, a.body_->it, b.body_->it, result->context());
  return Polynomial(result);
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
  same_ring(a, b);
  const Built result = build(a);
  fmpq_mpoly_mul(result->it, a.body_->it, b.body_->it, result->context());
  return reduced(result);
}

Polynomial operator*(const Rational& a, const Polynomial& b) {
  const Built result = build(b);
  fmpq_mpoly_scalar_mul_fmpq(result->it, b.body_->it, flint::Fmpq(a).it, result->context());
  return Polynomial(result);
}

Polynomial Polynomial::operator-() const {
  return Rational(-1) * *this;
}

Polynomial Polynomial::pow(int exponent) const {
  require(exponent >= 0, "Polynomial::pow: negative exponent");
  const RingPtr& r = body_->ring;
  if (!r->tower()) {
    const Built result = build(*this);
    fmpq_mpoly_pow_ui(result->it, body_->it, exponent, result->context());
    return Polynomial(result);
  }
  Polynomial result = r->constant(1), square = *this;
  for (int rest = exponent; rest > 0; rest /= 2) {
    if (rest % 2 == 1) result = result * square;
    if (rest > 1) square = square * square;
  }
  return result;
}

bool operator==(const Polynomial& a, const Polynomial& b) {
  same_ring(a, b);
  return fmpq_mpoly_equal(a.body_->it, b.body_->it, a.body_->context());
}

Polynomial Polynomial::derivative(int variable) const {
  const Built result = build(*this);
  fmpq_mpoly_derivative(result->it, body_->it, variable, result->context());
  return Polynomial(result);
}

Polynomial Polynomial::substitute(const RingPtr& target,
                                  const std::vector<Polynomial>& values) const {
  const Ring::Body& from = ring().body();
  require(values.size() == from.variables.size(), "substitute: one value a variable");
  require(target->tower() == from.tower, "substitute: another tower");
  // Horner, variable by variable, so that the normal form is kept small.
  const auto horner = [&](const auto& self, const std::map<Exponents, Polynomial>& terms,
                          std::size_t variable) -> Polynomial {
    if (variable == values.size()) return target->embed(terms.begin()->second);
    std::map<int, std::map<Exponents, Polynomial>> by_power;
    for (const auto& [exponents, c] : terms)
      by_power[exponents[variable]].emplace(exponents, c);
    Polynomial result = target->constant(0);
    int power = 0;
    for (auto it = by_power.rbegin(); it != by_power.rend(); ++it) {
      if (it != by_power.rbegin()) result = result * values[variable].pow(power - it->first);
      result = result + self(self, it->second, variable + 1);
      power = it->first;
    }
    return power > 0 ? result * values[variable].pow(power) : result;
  };
  const auto numerators = this->numerators();
  if (numerators.terms.empty()) return target->constant(0);
  const RingPtr numbers = Ring::make(from.tower, {});
  std::map<Exponents, Polynomial> terms;
  for (const auto& [exponents, coordinates] : numerators.terms)
    terms.emplace(exponents, numbers->number(coordinates, numerators.denominator));
  return horner(horner, terms, 0);
}

std::map<Exponents, Polynomial> Polynomial::coefficients(
    const std::vector<int>& variables) const {
  std::map<Exponents, std::map<Exponents, Polynomial>> groups;
  const auto numerators = this->numerators();
  const RingPtr numbers = Ring::make(ring().tower(), {});
  for (const auto& [exponents, coordinates] : numerators.terms) {
    Exponents outer, inner = exponents;
    for (const int v : variables) {
      outer.push_back(exponents[v]);
      inner[v] = 0;
    }
    groups[outer].emplace(inner, numbers->number(coordinates, numerators.denominator));
  }
  std::map<Exponents, Polynomial> result;
  for (const auto& [outer, terms] : groups)
    result.emplace(outer, body_->ring->polynomial(terms));
  return result;
}

Polynomial::Numerators Polynomial::numerators() const {
  const Ring::Body& r = ring().body();
  Numerators result;
  const Rational content = flint::rational(body_->it->content);
  result.denominator = content.get_den();
  const int size = dimension(r.tower);
  std::vector<ulong> exponents(std::max(1, r.symbols()));
  flint::Fmpz coefficient;
  for (slong i = 0; i < fmpz_mpoly_length(body_->it->zpoly, r.integral()); ++i) {
    fmpz_mpoly_get_term_exp_ui(exponents.data(), body_->it->zpoly, i, r.integral());
    fmpz_mpoly_get_term_coeff_fmpz(coefficient.it, body_->it->zpoly, i, r.integral());
    std::size_t index = 0;
    for (int k = static_cast<int>(r.generators.size()) - 1; k >= 0; --k)
      index = index * r.generators[k]->degree() + exponents[r.position(k)];
    Exponents of_variables(exponents.begin(), exponents.begin() + r.variables.size());
    auto& coordinates = result.terms[of_variables];
    if (coordinates.empty()) coordinates.resize(size);
    coordinates[index] = content.get_num() * flint::integer(coefficient.it);
  }
  return result;
}

}  // namespace seam::exact
