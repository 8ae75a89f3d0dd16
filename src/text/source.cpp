// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "text/source.h"

#include <algorithm>

namespace seam::text {
namespace {

std::size_t line_begin(std::string_view bytes, std::size_t offset) {
  const std::size_t newline =
      offset == 0 ? std::string_view::npos : bytes.rfind('\n', offset - 1);
  return newline == std::string_view::npos ? 0 : newline + 1;
}

// Every byte but the continuation bytes of UTF-8 begins a code point.
bool begins_code_point(char c) {
  return (static_cast<unsigned char>(c) & 0xC0) != 0x80;
}

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

}  // namespace

Position position(const Source& source, std::size_t offset) {
  const std::string_view bytes = source.bytes;
  offset = std::min(offset, bytes.size());
  std::size_t begin = line_begin(bytes, offset);
  const auto lines = std::count(bytes.begin(), bytes.begin() + begin, '\n');
  if (begin == 0 && bytes.starts_with(byte_order_mark))
    begin = std::min(offset, byte_order_mark.size());
  const std::string_view before = bytes.substr(begin, offset - begin);
  const auto columns = std::ranges::count_if(before, begins_code_point);
  return {static_cast<int>(lines) + 1, static_cast<int>(columns) + 1};
}

std::string_view line_at(const Source& source, std::size_t offset) {
  const std::string_view bytes = source.bytes;
  offset = std::min(offset, bytes.size());
  std::size_t begin = line_begin(bytes, offset);
  const std::size_t end = std::min(bytes.find('\n', offset), bytes.size());
  if (begin == 0 && bytes.starts_with(byte_order_mark)) begin = byte_order_mark.size();
  std::string_view line = bytes.substr(begin, std::max(begin, end) - begin);
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace seam::text
