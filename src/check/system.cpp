// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "check/system.h"

#include <algorithm>
#include <iterator>
#include <utility>

// A polynomial in real variables is 0 for all their values exactly when its coefficients are.

namespace seam::check {
namespace {

std::vector<Polynomial> coefficients(Context& context, const Polynomial& formula,
                                     const std::vector<int>& variables) {
  std::map<std::vector<int>, Polynomial> parts = {{{}, formula}};
  for (const int variable : variables) {
    std::map<std::vector<int>, Polynomial> finer;
    for (const auto& [exponents, part] : parts)
      for (auto& [e, coefficient] : by_exponent(part, variable, context.meter())) {
        std::vector<int> longer = exponents;
        longer.push_back(e);
        finer.emplace(std::move(longer), std::move(coefficient));
      }
    parts = std::move(finer);
  }
  std::vector<Polynomial> result;
  for (auto& [exponents, part] : parts)
    if (!part.is_zero()) result.push_back(std::move(part));
  return result;
}

}  // namespace

std::vector<Polynomial> read_system(Context& context,
                                    const std::vector<certificate::Term>& formulas,
                                    const std::vector<std::string>& for_all,
                                    const std::set<int>& others) {
  std::vector<int> ordered;
  for (const std::string& name : for_all) ordered.push_back(context.variable(name));
  std::set<int> all = context.variables(for_all);
  for (const int variable : others)
    demand(all.insert(variable).second, "degenerate: a variable is bound twice");
  std::vector<Polynomial> system;
  for (const certificate::Term term : formulas) {
    const Polynomial formula = context.value(term);
    demand(context.depends_only_on(formula, all), "degenerate: a variable that is not bound");
    std::ranges::move(coefficients(context, formula, ordered), std::back_inserter(system));
  }
  return system;
}

}  // namespace seam::check
