// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace seam::claims {

/// A stretch of text that stays on one line, and how a line may end in front of it.
struct Piece {
  enum class Break { none, soft, hard };  ///< never; where the line is too long; always
  Break before = Break::none;
  bool blank = false;  ///< a blank stands in front, unless a line ends there
  int depth = 0;       ///< of the break: lines end at shallow breaks first
  std::string text;
};

/// The pieces in lines of at most 96 columns where that can be. The first begins at
/// `column`, the others at `indent` or deeper. Depends on nothing else.
std::string lay_out(const std::vector<Piece>& pieces, std::size_t column, std::size_t indent);

/// In code points.
std::size_t width(const std::string& text);

}  // namespace seam::claims
