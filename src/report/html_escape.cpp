// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/html_escape.h"

#include <algorithm>

#include "text/utf8.h"

namespace seam::report {
namespace {

constexpr std::string_view replacement = "\uFFFD";

// The picture of a control character: U+2400 and on.
std::string picture(char32_t control) {
  const char32_t point = control == 0x7F ? 0x2421 : 0x2400 + control;
  return {'\xE2', static_cast<char>(0x90), static_cast<char>(0x80 | (point & 0x3F))};
}

std::string escaped(const text::CodePoint& point, std::string_view bytes) {
  switch (point.value) {
    case U'&':
      return "&amp;";
    case U'<':
      return "&lt;";
    case U'>':
      return "&gt;";
    case U'"':
      return "&quot;";
    case U'\'':
      return "&#39;";
    case U'\n':
    case U'\t':
      return " ";
    default:
      break;
  }
  if (point.value < 0x20 || point.value == 0x7F) return picture(point.value);
  if (text::invisible(point.value) || (point.value & 0xFFFE) == 0xFFFE)
    return std::string(replacement);
  return std::string(bytes);
}

}  // namespace

std::string html_escape(std::string_view text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const text::CodePoint point = text::decode(text, at);
    const std::size_t length = std::max<std::size_t>(point.length, 1);
    result +=
        point.length == 0 ? std::string(replacement) : escaped(point, text.substr(at, length));
    at += length;
  }
  return result;
}

std::string html_element(std::string_view tag_and_attributes, const std::string& content) {
  const std::string tag(tag_and_attributes.substr(0, tag_and_attributes.find(' ')));
  return "<" + std::string(tag_and_attributes) + ">" + content + "</" + tag + ">";
}

}  // namespace seam::report
