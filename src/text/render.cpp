// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <algorithm>

#include "text/source.h"
#include "text/utf8.h"

// A line is shown as a window of at most `before` + `after` code points round
// the place, so that a file of one endless line gives a message of a few lines.

namespace seam::text {
namespace {

constexpr std::size_t before = 60, after = 40;

// Cuts a window out of a text, at code points; says how wide what it kept is.
struct Window {
  std::string text;
  std::size_t width = 0;
};

Window last(std::string_view bytes, std::size_t width) {
  std::size_t begin = bytes.size(), kept = 0;
  while (begin > 0 && kept < width) {
    --begin;
    while (begin > 0 && (static_cast<unsigned char>(bytes[begin]) & 0xC0) == 0x80) --begin;
    ++kept;
  }
  const std::string text = printable(bytes.substr(begin));
  if (begin == 0) return {text, kept};
  return {"…" + text, kept + 1};
}

Window first(std::string_view bytes, std::size_t width) {
  std::size_t end = 0, kept = 0;
  while (end < bytes.size() && kept < width) {
    end += std::max<std::size_t>(decode(bytes, end).length, 1);
    ++kept;
  }
  const std::string text = printable(bytes.substr(0, end));
  return {end < bytes.size() ? text + "…" : text, kept};
}

}  // namespace

std::string render(const Diagnostic& diagnostic) {
  const Source& source = *diagnostic.where.source;
  const std::size_t begin = std::min(diagnostic.where.begin, source.bytes.size());
  const Position place = position(source, begin);
  const std::string number = std::to_string(place.line);

  const std::string_view line = line_at(source, begin);
  const auto line_begin = static_cast<std::size_t>(line.data() - source.bytes.data());
  const std::size_t in_line =
      begin < line_begin ? 0 : std::min(begin - line_begin, line.size());
  const std::size_t length = std::max(diagnostic.where.end, begin) - begin;
  const Window left = last(line.substr(0, in_line), before);
  const Window right = first(line.substr(in_line), after);
  const Window marked = first(line.substr(in_line, length), after);

  std::string out = printable(source.name) + ":" + number + ":" + std::to_string(place.column) +
                    ": error: " + printable(diagnostic.message) + "\n";
  const std::string margin(number.size(), ' ');
  out += "  " + number + " | " + left.text + right.text + "\n";
  out += "  " + margin + " | " + std::string(left.width, ' ') + "^" +
         std::string(marked.width > 1 ? marked.width - 1 : 0, '~') + "\n";
  if (!diagnostic.hint.empty())
    out += "  " + margin + " = " + printable(diagnostic.hint) + "\n";
  return out;
}

}  // namespace seam::text
