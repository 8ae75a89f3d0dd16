// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "text/utf8.h"

#include <cstdio>

// Overlong forms, surrogates and values above 10FFFF are no UTF-8 (RFC 3629).

namespace seam::text {
namespace {

unsigned char byte(std::string_view bytes, std::size_t i) {
  return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0;
}

}  // namespace

CodePoint decode(std::string_view bytes, std::size_t offset) {
  constexpr CodePoint wrong{0, 0};
  const unsigned char lead = byte(bytes, offset);
  if (lead < 0x80) return {lead, 1};
  if (lead < 0xC2 || lead > 0xF4) return wrong;
  const std::size_t length = lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
  char32_t value = lead & (0x7Fu >> length);
  for (std::size_t i = 1; i < length; ++i) {
    const unsigned char next = byte(bytes, offset + i);
    if ((next & 0xC0) != 0x80) return wrong;
    value = value << 6 | (next & 0x3Fu);
  }
  const bool overlong = (length == 3 && value < 0x800) || (length == 4 && value < 0x10000);
  const bool surrogate = value >= 0xD800 && value <= 0xDFFF;
  if (overlong || surrogate || value > 0x10FFFF) return wrong;
  return {value, length};
}

std::optional<std::size_t> invalid_utf8(std::string_view bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const CodePoint point = decode(bytes, at);
    if (point.length == 0) return at;
    at += point.length;
  }
  return std::nullopt;
}

bool invisible(char32_t c) {
  const bool control =
      (c < 0x20 && c != '\t' && c != '\n' && c != '\r') || (c >= 0x7F && c < 0xA0);
  const bool reorders = c == 0x061C || c == 0x200E || c == 0x200F ||
                        (c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069);
  return control || reorders;
}

std::string code_name(char32_t c) {
  char text[16];
  std::snprintf(text, sizeof text, "U+%04X", static_cast<unsigned>(c));
  return text;
}

std::string printable(std::string_view bytes) {
  std::string out;
  for (std::size_t at = 0; at < bytes.size();) {
    const CodePoint point = decode(bytes, at);
    const std::size_t length = point.length == 0 ? 1 : point.length;
    if (point.value == '\t')
      out += ' ';
    else if (point.length == 0 || invisible(point.value) || point.value == '\n' ||
             point.value == '\r')
      out += "\uFFFD";
    else
      out.append(bytes.substr(at, length));
    at += length;
  }
  return out;
}

}  // namespace seam::text
