// SPDX-License-Identifier: GPL-3.0-or-later
#include "coq/domain.h"
#include "coq/stated.h"

// What is so for all real values of the variables is so on the domain: hypotheses about it are
// said and not used.

namespace seam::coq {

void write_identity(Draft& draft, const certificate::Sign& sign,
                    const std::set<std::string>& variables) {
  Stated stated = place_domain(draft, sign, variables, false);
  say_for_all(draft, stated, sign);
  draft.prove("compute_exactly_by (zero_holds " + draft.generators() + " " +
              list(stated.variables) + " " + draft.definitions() + " " + draft.named() + " " +
              draft.formulas().write(sign.formula).code + " " + draft.roots() + " " +
              draft.defined() + ").");
}

void write_number(Draft& draft, const certificate::Sign& sign,
                  const std::set<std::string>& variables) {
  Stated stated = place_domain(draft, sign, variables, false);
  std::vector<std::string> values = stated.variables;
  for (const Factor& factor : stated.factors)
    if (factor.shape == Factor::Shape::general)
      values.insert(values.end(), factor.coordinates.begin(), factor.coordinates.end());
  say_for_all(draft, stated, sign);
  draft.prove(std::string("compute_by (number_holds ") + relation_code(sign.relation) + " " +
              draft.generators() + " " + list(values) + " " + draft.definitions() + " " +
              draft.named() + " " + draft.formulas().write(sign.formula).code + " " +
              draft.roots() + " " + draft.defined() + ").");
}

}  // namespace seam::coq
