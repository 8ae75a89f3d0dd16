// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "exact/field.h"

namespace seam::exact {

/// A polynomial without multiple roots, with the same roots. Requires f != 0.
Univariate squarefree(const Univariate& f);

/// A real root: the only one in [low, high]. Either low = high is the root, or the polynomial
/// has opposite signs at low and high.
struct RootInterval {
  Rational low, high;
};

/// The real roots of a squarefree polynomial, ascending; the intervals do not overlap. Sturm.
std::vector<RootInterval> real_roots(const Univariate& squarefree);
std::vector<RootInterval> real_roots(const Univariate& squarefree, const Rational& low,
                                     const Rational& high);  ///< those in [low, high]

/// Half as wide at least.
RootInterval halved(const Univariate& squarefree, const RootInterval&);

/// The monic irreducible factor (over the tower of its coefficients) that vanishes at the root.
/// Trager.
Univariate irreducible_factor(const Univariate& squarefree, RootInterval root);

/// An interval around a root of an irreducible polynomial of degree >= 2: the polynomial has
/// opposite signs at the ends, and its derivative, in plain interval arithmetic, is not 0 over
/// it.
struct Bracket {
  Rational low, high;
};
Bracket bracket(const Univariate& irreducible, RootInterval root);

/// The field with that root adjoined. The polynomial is monic.
TowerPtr adjoin(const Univariate& irreducible, const std::string& name, const Bracket&);

}  // namespace seam::exact
