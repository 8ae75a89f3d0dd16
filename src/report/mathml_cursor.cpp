// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/mathml_cursor.h"

namespace seam::report {

bool MathmlCursor::is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

bool MathmlCursor::is_digit(char c) {
  return c >= '0' && c <= '9';
}

bool MathmlCursor::take(std::string_view text) {
  if (!at(text)) return false;
  rest_.remove_prefix(text.size());
  return true;
}

char MathmlCursor::next() {
  if (rest_.empty()) throw Unknown{};
  const char c = rest_.front();
  rest_.remove_prefix(1);
  return c;
}

void MathmlCursor::skip_blanks() {
  while (at(" ") || at("\n")) next();
}

std::string_view MathmlCursor::name() {
  std::size_t length = 0;
  while (length < rest_.size() && is_letter(rest_[length])) ++length;
  if (length == 0 && !rest_.empty()) length = 1;
  const std::string_view result = rest_.substr(0, length);
  rest_.remove_prefix(length);
  return result;
}

// Letters, digits and signs between braces.
std::string MathmlCursor::letters() {
  if (!take("{")) throw Unknown{};
  std::string result;
  while (!take("}")) {
    const char c = next();
    if (c == '\\' && at("_"))
      result += next();
    else if (is_letter(c) || is_digit(c) || c == ' ' || c == ',' || c == '-')
      result += c;
    else
      throw Unknown{};
  }
  return result;
}

// What stands between the braces of \text; no mathematics inside.
std::string MathmlCursor::text() {
  if (!take("{")) throw Unknown{};
  std::string plain;
  for (;;) {
    if (take("}")) break;
    if (take("``")) {
      plain += "“";
      continue;
    }
    if (take("''")) {
      plain += "”";
      continue;
    }
    const char c = next();
    if (c == '~' || c == ' ')
      plain += "\u00A0";
    else if (c != '\\' && c != '{' && c != '$')
      plain += c;
    else if (c == '\\')
      plain += written(name());
    else
      throw Unknown{};
  }
  return plain;
}

std::string MathmlCursor::written(std::string_view name) {
  if (name == "textbackslash" || name == "textasciicircum" || name == "textasciitilde") {
    if (!take("{}")) throw Unknown{};
    return name == "textbackslash" ? "\\" : name == "textasciicircum" ? "^" : "~";
  }
  if (name.size() == 1 && std::string_view("_%&#${}").find(name) != std::string_view::npos)
    return std::string(name);
  throw Unknown{};
}

}  // namespace seam::report
