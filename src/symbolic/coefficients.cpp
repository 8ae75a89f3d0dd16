// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/coefficients.h"

#include <algorithm>

#include "exact/polynomial.h"
#include "symbolic/expand.h"

namespace seam::symbolic {

namespace {

struct Expanded {
  exact::Polynomial polynomial;
  std::map<std::string, Formula> written;  // what the names of roots and inverses stand for
};

// Over the field of its numbers; the chosen variables come first.
Expanded expanded(const Formula& f, const std::vector<std::string>& chosen,
                  const Numbers& numbers) {
  std::vector<std::string> ring_variables = chosen;
  for (const std::string& name : variables(f))
    if (std::ranges::find(chosen, name) == chosen.end()) ring_variables.push_back(name);
  const Numbers::Field& field = numbers.field(f);
  for (const auto& number : field.transcendental) ring_variables.push_back(number.name);
  Atoms atoms;
  atoms.add(f);
  std::map<std::string, Formula> written;
  for (const Atoms::Entry& entry : atoms.entries()) {
    const auto inside = variables(entry.formula);
    for (const std::string& name : chosen)
      if (inside.contains(name))
        throw FormulaLimit(
            "what stands under a root or below a fraction bar is no polynomial in '" + name +
            "'");
    ring_variables.push_back(entry.name);
    written.emplace(entry.name, entry.formula);
  }
  Expansion expansion(exact::Ring::make(field.ring->tower(), ring_variables), atoms,
                      field.values);
  return {expansion(f), std::move(written)};
}

}  // namespace

Coefficients coefficients(const Formula& f, const std::vector<std::string>& chosen,
                          const Numbers& numbers) {
  std::vector<int> indices;
  for (std::size_t i = 0; i < chosen.size(); ++i) indices.push_back(static_cast<int>(i));
  const auto [polynomial, written] = expanded(f, chosen, numbers);
  Coefficients result;
  for (const auto& [exponents, coefficient] : polynomial.coefficients(indices))
    result.emplace(exponents, subst(formula(coefficient), written));
  return result;
}

std::vector<Monomial> monomials(const Formula& f, const Numbers& numbers) {
  const auto [polynomial, written] = expanded(f, {}, numbers);
  std::vector<Monomial> result = monomials(polynomial);
  for (Monomial& monomial : result) monomial.powers = subst(monomial.powers, written);
  return result;
}

bool vanishes(const Formula& f, const Numbers& numbers) {
  return monomials(f, numbers).empty();
}

}  // namespace seam::symbolic
