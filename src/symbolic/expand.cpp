// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/expand.h"

#include <algorithm>
#include <utility>

#include "exact/contract.h"

namespace seam::symbolic {

using exact::Integer;
using exact::Polynomial;
using exact::Rational;
using exact::require;

Expansion::Expansion(exact::RingPtr ring, Atoms atoms, std::map<std::string, Polynomial> values)
    : ring_(std::move(ring)), atoms_(std::move(atoms)), values_(std::move(values)) {
  for (const Atoms::Entry& entry : atoms_.entries()) {
    if (entry.formula.kind() != Formula::Kind::root) continue;
    const auto& names = ring_->variables();
    const auto place = std::ranges::find(names, entry.name);
    require(place != names.end(), "Expansion: a root that the ring does not have");
    rules_.push_back({static_cast<int>(place - names.begin()), entry.formula.exponent(),
                      (*this)(entry.formula.operands()[0])});
  }
  const auto is = [](const Atoms::Entry& entry, const char* function) {
    return entry.formula.kind() == Formula::Kind::applied && entry.formula.name() == function;
  };
  const auto variable = [this](const Atoms::Entry& entry) {
    const auto& names = ring_->variables();
    return static_cast<int>(std::ranges::find(names, entry.name) - names.begin());
  };
  for (const Atoms::Entry& sine : atoms_.entries())
    for (const Atoms::Entry& cosine : atoms_.entries())
      if (is(sine, "sin") && is(cosine, "cos") &&
          sine.formula.operands()[0].same(cosine.formula.operands()[0]))
        add_circle(variable(sine), variable(cosine));
}

void Expansion::add_circle(int sine, int cosine) {
  const Polynomial c = ring_->variable(cosine);
  rules_.push_back({sine, 2, ring_->constant(1) - c * c});
}

// From the last root to the first: what comes in for a root holds only roots before it.
Polynomial Expansion::reduced(Polynomial p) const {
  for (auto rule = rules_.rbegin(); rule != rules_.rend(); ++rule) {
    if (p.degree(rule->variable) < rule->index) continue;
    Polynomial result = ring_->constant(0);
    for (const auto& [exponents, coefficient] : p.coefficients({rule->variable})) {
      const int low = exponents[0] % rule->index, high = exponents[0] / rule->index;
      result = result + coefficient * ring_->variable(rule->variable).pow(low) *
                            rule->radicand.pow(high);
    }
    p = std::move(result);
  }
  return p;
}

Polynomial Expansion::power(const Polynomial& base, int exponent) const {
  const bool holds_root = std::ranges::any_of(
      rules_, [&](const Rule& rule) { return base.degree(rule.variable) > 0; });
  if (!holds_root) return base.pow(exponent);
  Polynomial result = ring_->constant(1), square = base;
  for (int rest = exponent; rest > 0; rest /= 2) {
    if (rest % 2 == 1) result = reduced(result * square);
    if (rest > 1) square = reduced(square * square);
  }
  return result;
}

Polynomial Expansion::operator()(const Formula& formula) {
  if (const auto known = done_.find(formula.identity()); known != done_.end())
    return known->second.second;
  Polynomial result = compute(formula);
  done_.try_emplace(formula.identity(), formula, result);
  return result;
}

Polynomial Expansion::compute(const Formula& formula) {
  switch (formula.kind()) {
    case Formula::Kind::constant:
      return ring_->constant(formula.value());
    case Formula::Kind::symbol: {
      if (const auto number = values_.find(formula.name()); number != values_.end())
        return ring_->embed(number->second);
      const auto symbol = ring_->symbol(formula.name());
      require(symbol.has_value(), "Expansion: a symbol that the ring does not have");
      return *symbol;
    }
    case Formula::Kind::sum: {
      Polynomial result = ring_->constant(0);
      for (const Formula& term : formula.operands()) result = result + (*this)(term);
      return result;
    }
    case Formula::Kind::product: {
      Polynomial result = ring_->constant(1);
      for (const Formula& factor : formula.operands())
        result = reduced(result * (*this)(factor));
      return result;
    }
    case Formula::Kind::power:
      return power((*this)(formula.operands()[0]), formula.exponent());
    case Formula::Kind::known:
      return (*this)(formula.operands()[0]);
    case Formula::Kind::root:
    case Formula::Kind::inverse:
    case Formula::Kind::applied:
      return *ring_->symbol(atoms_[formula].name);
  }
  throw exact::ContractError("Expansion: no such kind of formula");
}

std::vector<Monomial> monomials(const Polynomial& polynomial) {
  const auto [terms, denominator] = polynomial.numerators();
  const auto& variables = polynomial.ring().variables();
  const auto generators = exact::steps(polynomial.ring().tower());
  std::vector<Monomial> result;
  for (auto term = terms.rbegin(); term != terms.rend(); ++term) {
    std::vector<Formula> monomial;
    for (std::size_t i = 0; i < variables.size(); ++i)
      monomial.push_back(symbolic::power(Formula::symbol(variables[i]), term->first[i]));
    for (std::size_t index = 0; index < term->second.size(); ++index) {
      Rational coefficient(term->second[index], denominator);
      if (coefficient == 0) continue;
      coefficient.canonicalize();
      std::vector<Formula> factors;
      std::size_t rest = index;
      for (const exact::Tower* generator : generators) {
        const int exponent = static_cast<int>(rest % generator->degree());
        rest /= generator->degree();
        for (int k = 0; k < exponent; ++k) coefficient *= generator->scale();
        factors.push_back(symbolic::power(Formula::symbol(generator->symbol()), exponent));
      }
      factors.insert(factors.end(), monomial.begin(), monomial.end());
      result.push_back({coefficient, product(std::move(factors))});
    }
  }
  return result;
}

Formula formula(const Polynomial& polynomial) {
  std::vector<Formula> terms;
  for (const auto& [coefficient, powers] : monomials(polynomial)) {
    std::vector<Formula> factors = {Formula(coefficient)};
    if (powers.kind() == Formula::Kind::product)
      factors.insert(factors.end(), powers.operands().begin(), powers.operands().end());
    else
      factors.push_back(powers);
    terms.push_back(product(std::move(factors)));
  }
  return sum(std::move(terms));
}

}  // namespace seam::symbolic
