// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace seam::claims {

/// The words that begin an item, the clauses after a claim's statement, and the
/// words that stand between statements.
const std::vector<std::string>& item_words();
const std::vector<std::string>& clause_words();
const std::vector<std::string>& operator_words();
/// The clauses after what a figure shows, and what it can be drawn with.
const std::vector<std::string>& figure_clauses();
const std::vector<std::string>& figure_parts();

/// A word of the grammar, which no name may be.
bool reserved(std::string_view word);

}  // namespace seam::claims
