// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "exact/polynomial.h"

// Numbers are elements, without variables, of a ring; a univariate polynomial is the
// list of its coefficients, the constant first, the last not 0 (0: no coefficient).
namespace seam::exact {

Sign sign(const Polynomial& number);
Ball ball(const Polynomial& number);
Enclosure enclosure(const Polynomial& number, long bits);

/// 1/number. Requires number != 0.
Polynomial inverse(const Polynomial& number);

using Univariate = std::vector<Polynomial>;

int degree(const Univariate&);                           ///< -1 for 0
Univariate univariate(const Polynomial&, int variable);  ///< requires no other variable
Univariate trimmed(Univariate);
Univariate operator+(const Univariate&, const Univariate&);
Univariate operator-(const Univariate&, const Univariate&);
Univariate operator*(const Univariate&, const Univariate&);
Univariate operator*(const Polynomial&, const Univariate&);
Univariate derivative(const Univariate&);
Univariate monic(const Univariate&);                        ///< requires != 0
Polynomial value(const Univariate&, const Polynomial& at);  ///< requires != 0

struct Division {
  Univariate quotient, remainder;
};
Division divide(const Univariate&, const Univariate& by);  ///< requires by != 0

/// gcd = a * cofactor_a + b * cofactor_b, monic; not both 0.
struct Gcd {
  Univariate gcd, cofactor_a, cofactor_b;
};
Gcd extended_gcd(const Univariate& a, const Univariate& b);
Univariate gcd(const Univariate& a, const Univariate& b);

}  // namespace seam::exact
