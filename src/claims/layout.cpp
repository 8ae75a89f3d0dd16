// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/layout.h"

#include <algorithm>
#include <limits>

// A stretch that does not fit its line is cut at its shallowest breaks into groups. A group
// goes on the current line if it fits there, else on a new one; one that fits on no line is cut
// again, one step deeper.

namespace seam::claims {
namespace {

constexpr std::size_t columns = 96;
constexpr std::size_t step = 4;
constexpr std::size_t deepest_indent = 48;

using Pieces = std::vector<Piece>;
using Break = Piece::Break;

class Layout {
 public:
  Layout(const Pieces& pieces, std::size_t column) : pieces_(pieces), column_(column) {}

  void put(std::size_t begin, std::size_t end, std::size_t indent) {
    if (fits(begin, end)) return put_flat(begin, end);
    const int depth = shallowest(begin, end);
    if (depth == std::numeric_limits<int>::max()) return put_flat(begin, end);
    for (std::size_t at = begin; at < end;) {
      const std::size_t next = group_end(at, end, depth);
      const bool must = at != begin && pieces_[at].before == Break::hard;
      if (must || (at != begin && !fits(at, next))) new_line(indent);
      put(at, next, std::min(indent + step, deepest_indent));
      at = next;
    }
  }

  std::string text;

 private:
  // On the rest of the current line; only the first piece's own break may be hard.
  bool fits(std::size_t begin, std::size_t end) const {
    std::size_t column = column_;
    for (std::size_t i = begin; i < end; ++i) {
      if (i > begin && pieces_[i].before == Break::hard) return false;
      column += width(pieces_[i].text) + (pieces_[i].blank ? 1 : 0);
      if (column > columns) return false;
    }
    return true;
  }

  int shallowest(std::size_t begin, std::size_t end) const {
    int depth = std::numeric_limits<int>::max();
    for (std::size_t i = begin + 1; i < end; ++i)
      if (pieces_[i].before != Break::none) depth = std::min(depth, pieces_[i].depth);
    return depth;
  }

  std::size_t group_end(std::size_t begin, std::size_t end, int depth) const {
    std::size_t i = begin + 1;
    while (i < end && (pieces_[i].before == Break::none || pieces_[i].depth > depth)) ++i;
    return i;
  }

  void put_flat(std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const bool blank = pieces_[i].blank && !at_line_begin_;
      text += (blank ? " " : "") + pieces_[i].text;
      column_ += width(pieces_[i].text) + (blank ? 1 : 0);
      at_line_begin_ = false;
    }
  }

  void new_line(std::size_t indent) {
    text += '\n';
    text.append(indent, ' ');
    column_ = indent;
    at_line_begin_ = true;
  }

  const Pieces& pieces_;
  std::size_t column_;
  bool at_line_begin_ = true;
};

}  // namespace

std::string lay_out(const Pieces& pieces, std::size_t column, std::size_t indent) {
  Layout layout(pieces, column);
  layout.put(0, pieces.size(), indent);
  return std::move(layout.text);
}

std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

}  // namespace seam::claims
