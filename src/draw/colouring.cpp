// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <memory>

#include "draw/figure_parts.h"

namespace seam::draw {

Colouring colouring(const claims::MeantFigure& figure, std::size_t number,
                    const std::vector<std::string>& variables,
                    const std::function<std::vector<Expansion>(double u, double v)>& values,
                    const symbolic::Numbers& numbers) {
  if (!figure.colour) return {};
  const claims::MeantFigure::Colour& colour = *figure.colour;
  if (colour.formulas.empty()) {
    if (colour.text == "gauss")
      return [](const Jet& jet, double, double) { return jet.gauss(); };
    if (colour.text == "mean") return [](const Jet& jet, double, double) { return jet.mean(); };
    return {};
  }
  std::vector<std::string> all = variables;
  all.insert(all.end(), colour.position.begin(), colour.position.end());
  const symbolic::Formula& formula =
      colour.formulas[std::min(number, colour.formulas.size() - 1)];
  const RoundedFunction function(formula, all, numbers);
  return [=, has_position = !colour.position.empty()](const Jet& jet, double u, double v) {
    std::vector<Expansion> at = values(u, v);
    for (std::size_t i = 0; has_position && i < 3; ++i) at.push_back({jet.point[i]});
    return function(at).value;
  };
}

}  // namespace seam::draw
