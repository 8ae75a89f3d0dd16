// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include <vector>

#include "check/polynomial.h"

namespace seam::check {

/// Polynomials modulo the defining equations of numbers and functions. Results are in normal
/// form: no symbol that has a rule stands in the degree of its rule or above.
///
/// Equal normal forms have equal values. Different ones may have equal values too,
/// where a defining polynomial is reducible over the numbers before it.
class Ring {
 public:
  explicit Ring(Meter& meter) : meter_(&meter) {}

  Meter& meter() const { return *meter_; }

  /// Adds the rule of `polynomial` = 0 for the symbol, if its leading coefficient is
  /// rational; else the symbol stays without a rule. Symbols come in rising order,
  /// and a rule holds no symbol after its own.
  void add_rule(int index, const Polynomial& polynomial);

  Polynomial reduce(Polynomial p);
  Polynomial sum(Polynomial a, const Polynomial& b);
  Polynomial difference(Polynomial a, const Polynomial& b);
  Polynomial product(const Polynomial& a, const Polynomial& b);
  /// Requires n >= 0.
  Polynomial power(Polynomial base, int n);
  /// p with `value`, which may hold the symbol itself, for the symbol.
  Polynomial substitute(const Polynomial& p, int index, const Polynomial& value);

 private:
  struct Rule {
    int index, degree;
    std::vector<Polynomial> rows;  // row k is the normal form of symbol^(degree + k)
  };
  const Polynomial& row(Rule& rule, int e);

  Meter* meter_;
  std::vector<Rule> rules_;
};

}  // namespace seam::check
