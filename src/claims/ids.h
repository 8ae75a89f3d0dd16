// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "claims/meaning.h"
#include "claims/syntax.h"

namespace seam::claims {

/// A claim by its name.
struct Named {
  std::string id, title;
};

/// A cell of a table is called by the labels of its row and column, or their numbers.
Named cell(const Item& table, std::size_t row, std::size_t column);

/// The claims of a file and those that it includes, each cell of a table one: those of `mean`,
/// in its order, without working out what they say. What cannot be opened is left out.
std::vector<Named> named_claims(const File&, const Opener&);

}  // namespace seam::claims
