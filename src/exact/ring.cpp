// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "exact/contract.h"
#include "exact/polynomial_body.h"

namespace seam::exact {

using flint::Fmpz;
using flint::Mpoly;

namespace {

Mpoly tail_polynomial(const Ring::Body& ring, const Coordinates& coordinates) {
  Mpoly result(ring.integral());
  push_terms(result, ring, coordinates, Exponents(ring.variables.size(), 0));
  fmpz_mpoly_sort_terms(result.it, ring.integral());
  return result;
}

}  // namespace

Ring::Body::Body(TowerPtr t, std::vector<std::string> v)
    : tower(std::move(t)), generators(steps(tower)), variables(std::move(v)) {
  fmpq_mpoly_ctx_init(context, std::max(1, symbols()), ORD_LEX);
  for (const Tower* generator : generators) {
    tails.emplace_back();
    for (const Coordinates& coordinates : generator->tail())
      tails.back().push_back(tail_polynomial(*this, coordinates));
  }
}

Ring::Body::~Body() {
  tails.clear();
  fmpq_mpoly_ctx_clear(context);
}

void push_terms(Mpoly& sum, const Ring::Body& ring, const Coordinates& coordinates,
                const Exponents& exponents) {
  std::vector<ulong> all(std::max(1, ring.symbols()), 0);
  std::ranges::copy(exponents, all.begin());
  for (std::size_t i = 0; i < coordinates.size(); ++i) {
    if (coordinates[i] == 0) continue;
    std::size_t rest = i;
    for (std::size_t k = 0; k < ring.generators.size(); ++k) {
      const int degree = ring.generators[k]->degree();
      all[ring.variables.size() + k] = rest % degree;
      rest /= degree;
    }
    fmpz_mpoly_push_term_fmpz_ui(sum.it, Fmpz(coordinates[i]).it, all.data(), ring.integral());
  }
}

Ring::Ring() = default;
Ring::~Ring() = default;

RingPtr Ring::make(TowerPtr tower, std::vector<std::string> variables) {
  std::shared_ptr<Ring> ring(new Ring);
  ring->body_ = std::make_unique<Body>(std::move(tower), std::move(variables));
  return ring;
}

const TowerPtr& Ring::tower() const {
  return body_->tower;
}
const std::vector<std::string>& Ring::variables() const {
  return body_->variables;
}

Polynomial Ring::constant(const Rational& value) const {
  auto result = std::make_shared<Polynomial::Body>(shared_from_this());
  fmpq_mpoly_set_fmpq(result->it, flint::Fmpq(value).it, body_->context);
  return Polynomial(std::move(result));
}

Polynomial Ring::variable(int index) const {
  auto result = std::make_shared<Polynomial::Body>(shared_from_this());
  fmpq_mpoly_gen(result->it, index, body_->context);
  return Polynomial(std::move(result));
}

std::optional<Polynomial> Ring::symbol(const std::string& name) const {
  const auto& names = body_->variables;
  if (const auto at = std::ranges::find(names, name); at != names.end())
    return variable(static_cast<int>(at - names.begin()));
  for (std::size_t k = 0; k < body_->generators.size(); ++k)
    if (body_->generators[k]->symbol() == name)
      return Rational(1, body_->generators[k]->scale()) *
             variable(body_->position(static_cast<int>(k)));
  return std::nullopt;
}

Polynomial Ring::number(const Coordinates& coordinates, const Integer& denominator) const {
  auto result = std::make_shared<Polynomial::Body>(shared_from_this());
  Mpoly sum(body_->integral());
  push_terms(sum, *body_, coordinates, Exponents(body_->variables.size(), 0));
  fmpz_mpoly_sort_terms(sum.it, body_->integral());
  fmpz_mpoly_swap(result->it->zpoly, sum.it, body_->integral());
  Rational content(1, denominator);
  content.canonicalize();
  fmpq_set(result->it->content, flint::Fmpq(content).it);
  fmpq_mpoly_reduce(result->it, body_->context);
  return Polynomial(std::move(result));
}

Polynomial Ring::polynomial(const std::map<Exponents, Polynomial>& terms) const {
  Integer denominator = 1;
  std::vector<std::pair<Exponents, Polynomial::Numerators>> numbers;
  for (const auto& [exponents, coefficient] : terms) {
    require(coefficient.is_number(), "Ring::polynomial: a coefficient with variables");
    if (coefficient.is_zero()) continue;
    numbers.emplace_back(exponents, coefficient.numerators());
    denominator = lcm(denominator, numbers.back().second.denominator);
  }
  auto result = std::make_shared<Polynomial::Body>(shared_from_this());
  Mpoly sum(body_->integral());
  for (auto& [exponents, number] : numbers) {
    Coordinates coordinates = number.terms.begin()->second;
    for (Integer& c : coordinates) c *= denominator / number.denominator;
    push_terms(sum, *body_, coordinates, exponents);
  }
  fmpz_mpoly_sort_terms(sum.it, body_->integral());
  fmpz_mpoly_swap(result->it->zpoly, sum.it, body_->integral());
  fmpq_set(result->it->content, flint::Fmpq(Rational(1, denominator)).it);
  fmpq_mpoly_reduce(result->it, body_->context);
  return Polynomial(std::move(result));
}

Polynomial Ring::embed(const Polynomial& from) const {
  const auto& names = from.ring().variables();
  const auto numerators = from.numerators();
  auto result = std::make_shared<Polynomial::Body>(shared_from_this());
  Mpoly sum(body_->integral());
  for (const auto& [exponents, coordinates] : numerators.terms) {
    Exponents mapped(body_->variables.size(), 0);
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (exponents[i] == 0) continue;
      const auto at = std::ranges::find(body_->variables, names[i]);
      require(at != body_->variables.end(), "Ring::embed: a variable is missing");
      mapped[static_cast<std::size_t>(at - body_->variables.begin())] = exponents[i];
    }
    push_terms(sum, *body_, coordinates, mapped);
  }
  fmpz_mpoly_sort_terms(sum.it, body_->integral());
  fmpz_mpoly_swap(result->it->zpoly, sum.it, body_->integral());
  fmpq_set(result->it->content, flint::Fmpq(Rational(1, numerators.denominator)).it);
  fmpq_mpoly_reduce(result->it, body_->context);
  return Polynomial(std::move(result));
}

}  // namespace seam::exact
