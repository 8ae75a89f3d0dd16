// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/stating.h"

namespace seam::claims {

std::map<std::string, Formula> sample(const Context& context, Evaluator& evaluator,
                                      long weight) {
  std::map<std::string, Formula> point;
  const auto place = [&](const symbolic::Simplex& factor) {
    Formula total = 0;
    symbolic::Point sum(factor.variables.size(), Formula(0));
    for (std::size_t c = 0; c < factor.corners.size(); ++c) {
      const Formula share(c == 0 ? weight : 1);
      total += share * factor.corners[c][0];
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += share * factor.corners[c][i + 1];
    }
    const Formula inverse = evaluator.numbers.inverse(total);
    for (std::size_t i = 0; i < sum.size(); ++i)
      point[factor.variables[i]] = evaluator.numbers.normal_form(sum[i] * inverse);
  };
  for (const Parameter& parameter : evaluator.parameters) {
    if (parameter.set)
      place(*parameter.set);
    else
      point[parameter.name] = Formula(weight);
  }
  for (const symbolic::Simplex& factor : context.factors) place(factor);
  for (const std::string& line : context.lines) point[line] = Formula(weight);
  return point;
}

}  // namespace seam::claims
