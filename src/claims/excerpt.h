// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "claims/meaning.h"
#include "claims/syntax.h"

namespace seam::claims {

/// All expressions of an item, in the order in which they stand in it.
std::vector<Expression*> expressions_of(Item&);
std::vector<const Expression*> expressions_of(const Item&);

/// A file in which one item is what it is about: a claim, or a table of one row. All else is
/// what that rests on. What is said of the claim is the same as in the whole file; what a claim
/// names by `using` is left out.
struct Excerpt {
  File file;         ///< the last item is the claim or table
  std::string id;    ///< of the claim, or of one cell of the table, in the whole file
  std::string here;  ///< the id that it has in the excerpt
};

/// The file with the items of the files that it includes where they are included.
File with_included(const File&, const Opener&);

/// One for each claim of the file and each cell of its tables, in file order. An `include` is
/// not followed: its items have to stand in the file.
std::vector<Excerpt> excerpts(const File&);

}  // namespace seam::claims
