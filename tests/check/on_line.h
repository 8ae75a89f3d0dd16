// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include "builder.h"

namespace seam::check::test {

/// A sign of a polynomial in x, by its coefficients, on a domain; weights 1 and 2 to split at.
struct OnLine : Case {
  Term one, two, x;

  OnLine(const std::vector<std::string>& coefficients, Relation relation)
      : OnLine(coefficients, relation, [](Case& c) { return c.segment("x"); }) {}

  template <typename MakeDomain>
  OnLine(const std::vector<std::string>& coefficients, Relation relation, MakeDomain domain) {
    one = number(1);
    two = number(2);
    x = symbol("x");
    const Term formula = polynomial(x, coefficients);
    claim(Sign{formula, relation, {{domain(*this)}, {}}});
  }

  Sign& sign() { return std::get<Sign>(statement.obligations.front()); }
  Step halved() const { return split(0, {one, one}); }
  Witness at(const std::string& value) { return {{{"x"}, {number(value)}}, {}}; }
};

}  // namespace seam::check::test
