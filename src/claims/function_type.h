// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

namespace seam::claims {

/// The type of a parameter that is an arbitrary function: `function`, `function of 2`,
/// `vector 3 function`, `vector 3 function of 2`.
struct FunctionType {
  int arguments = 1, components = 1;

  /// Nothing if the type of a `param` item is another one; a number that does not fit is 0.
  static std::optional<FunctionType> of(const std::string& type);
};

}  // namespace seam::claims
