// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "certificate/statement.h"
#include "symbolic/formula.h"

namespace seam::claims {

using symbolic::Formula;

/// cos and sin of an angle.
struct Turn {
  Formula cos, sin;
};
/// Of the sum, and of an integer multiple.
Turn together(const Turn&, const Turn&);
Turn multiple(const Turn&, long n);

/// The monomial over the divisor: the operand of an elementary function as it is written.
Formula divided(const Formula& monomial, const exact::Integer& divisor);

/// The exponentials, cosines and sines of some formulas, of which exp(x/2) and exp(x/3) are
/// powers of one: exp(x/6).
class Angles {
 public:
  /// The formula itself, if it is one of these; not what it holds.
  void add(const Formula&);
  /// An elementary function as a polynomial in those of the least fractions of monomials that
  /// were added. Throws `Unsupported` if it cannot be stated.
  Formula in_finest(const Formula& applied) const;

 private:
  struct Angle {
    bool is_exp;
    Formula monomial;
    exact::Integer divisor;
  };
  static Angle angle(const Formula& applied);
  std::vector<Angle> angles_;
};

/// `none` for any other name.
certificate::Elementary kind_of(const std::string& function);

}  // namespace seam::claims
