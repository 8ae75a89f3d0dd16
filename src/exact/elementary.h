// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "exact/polynomial.h"

namespace seam::exact {

/// The value of a function, one of `exp`, `log`, `sin`, `cos`, `inverse`, or the number `pi`,
/// at a number.
struct Applied {
  std::string function;
  Polynomial argument;  ///< of pi: anything
};

/// [low, high] around a number: a polynomial in the variables of its ring, where the first of
/// these stand for the `values`, in turn; each argument holds, beside numbers of the tower,
/// only those before it. Nothing where at this precision no bounds are found.
std::optional<Enclosure> enclosure(const Polynomial& number, const std::vector<Applied>& values,
                                   long precision);

}  // namespace seam::exact
