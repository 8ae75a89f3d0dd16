// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace seam::text {

/// A file as it was read: the name it goes by in messages, and its bytes.
struct Source {
  std::string name;
  std::string bytes;
};

/// The bytes [begin, end) of a source. Keeps the source alive.
struct Span {
  std::shared_ptr<const Source> source;
  std::size_t begin = 0, end = 0;
};

/// 1-based; the column counts code points.
struct Position {
  int line = 1, column = 1;
};
Position position(const Source&, std::size_t offset);

/// The whole line that holds the offset, without its end.
std::string_view line_at(const Source&, std::size_t offset);

/// Something wrong in a file: what, where, and what would help.
struct Diagnostic {
  Span where;
  std::string message;  ///< `expected a closing parenthesis`
  std::string hint;     ///< `did you mean 'gauss'?`; may be empty
};

/// `file.seam:3:14: error: …`, the line, a mark under the place, the hint; several lines with a
/// final newline.
std::string render(const Diagnostic&);

/// Of the known names the one nearest to `name` (Damerau-Levenshtein, at most a third of its
/// length, at most 3), or nothing.
std::string nearest(std::string_view name, const std::vector<std::string>& known);

}  // namespace seam::text
