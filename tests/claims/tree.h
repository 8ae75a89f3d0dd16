// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "claims/syntax.h"

namespace seam::claims {

/// A tree in brackets: `(binary + (number 1) (name x))`.
std::string tree(const Expression&);

/// Reads an expression; an error is printed in its place.
std::string tree(const std::string& bytes);

std::shared_ptr<const text::Source> source(std::string bytes);

/// Everything that is wrong, as it is shown.
std::string messages(const Parsed&);

/// Equal as written, wherever they stand.
bool same(const Item&, const Item&);
bool same(const File&, const File&);

}  // namespace seam::claims
