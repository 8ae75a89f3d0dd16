// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/coefficients.h"

#include <algorithm>

#include "exact/polynomial.h"
#include "symbolic/expand.h"

namespace seam::symbolic {

Coefficients coefficients(const Formula& f, const std::vector<std::string>& chosen,
                          const Numbers& numbers) {
  std::vector<std::string> ring_variables = chosen;
  std::vector<int> indices;
  for (std::size_t i = 0; i < chosen.size(); ++i) indices.push_back(static_cast<int>(i));
  for (const std::string& name : variables(f))
    if (std::ranges::find(chosen, name) == chosen.end()) ring_variables.push_back(name);
  Expansion expansion(exact::Ring::make(numbers.tower(), ring_variables));
  Coefficients result;
  for (const auto& [exponents, coefficient] : expansion(f).coefficients(indices))
    result.emplace(exponents, formula(coefficient));
  return result;
}

}  // namespace seam::symbolic
