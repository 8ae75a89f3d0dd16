// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/expand.h"

#include <utility>

#include "exact/contract.h"

namespace seam::symbolic {

using exact::Integer;
using exact::Polynomial;
using exact::Rational;
using exact::require;

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
      for (const Formula& factor : formula.operands()) result = result * (*this)(factor);
      return result;
    }
    case Formula::Kind::power:
      return (*this)(formula.operands()[0]).pow(formula.exponent());
    case Formula::Kind::known:
      return (*this)(formula.operands()[0]);
  }
  throw exact::ContractError("Expansion: no such kind of formula");
}

Formula formula(const Polynomial& polynomial) {
  const auto [terms, denominator] = polynomial.numerators();
  const auto& variables = polynomial.ring().variables();
  const auto generators = exact::steps(polynomial.ring().tower());
  std::vector<Formula> sum_terms;
  for (auto term = terms.rbegin(); term != terms.rend(); ++term) {
    std::vector<Formula> monomial;
    for (std::size_t i = 0; i < variables.size(); ++i)
      monomial.push_back(power(Formula::symbol(variables[i]), term->first[i]));
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
        factors.push_back(power(Formula::symbol(generator->symbol()), exponent));
      }
      factors.insert(factors.end(), monomial.begin(), monomial.end());
      factors.insert(factors.begin(), Formula(coefficient));
      sum_terms.push_back(product(std::move(factors)));
    }
  }
  return sum(std::move(sum_terms));
}

}  // namespace seam::symbolic
