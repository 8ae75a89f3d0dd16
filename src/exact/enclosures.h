// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "exact/flint.h"
#include "exact/tower.h"

namespace seam::exact {

/// Balls around the basis of a tower. `root` is h.
struct Tower::Enclosures {
  long precision = 0;
  Rational low, high;  ///< brackets h; only ever narrowed
  flint::Arb root;
  std::vector<flint::Arb> basis;
};

/// At least `precision` bits, relative to the root. The tower is not null.
const Tower::Enclosures& enclosures(const TowerPtr&, long precision);

/// The least interval that holds a ball. It is finite.
Enclosure bounds(const flint::Arb&);

/// The number in a ball, `precision` bits for the arithmetic.
flint::Arb evaluate(const TowerPtr&, const Coordinates&, long precision);

}  // namespace seam::exact
