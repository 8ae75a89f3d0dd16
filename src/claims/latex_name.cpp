// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>

#include "claims/greek.h"
#include "claims/latex.h"
#include "text/utf8.h"

// Only letters, digits and signs listed here reach TeX as they are.

namespace seam::claims {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

// A Greek letter as a macro; capitals that look Latin have none.
std::string greek(std::string_view name) {
  if (name == "phi") return "\\varphi";
  if (name == "epsilon") return "\\varepsilon";
  constexpr std::string_view without =
      " omicron Alpha Beta Epsilon Zeta Eta Iota Kappa Mu Nu Omicron Rho Tau Chi ";
  const std::string word(name);
  if (!is_greek_name(name) || without.find(" " + word + " ") != std::string_view::npos)
    return {};
  return "\\" + word;
}

// Letters, digits and `_` only; whatever else is left out.
std::string plain(std::string_view word) {
  std::string out;
  for (const char c : word)
    if (c == '_')
      out += "\\_";
    else if (is_letter(c) || is_digit(c))
      out += c;
  return out;
}

std::string subscript(std::string_view text) {
  if (std::string letter = greek(text); !letter.empty()) return letter;
  const bool symbol = text.size() < 2 || std::all_of(text.begin() + 1, text.end(), is_digit);
  return symbol ? plain(text) : "\\mathrm{" + plain(text) + "}";
}

// A part of a name between dots, without primes.
std::string part(std::string_view text, bool operation) {
  const std::size_t underscore = text.find('_');
  std::string_view head = text.substr(0, underscore);
  std::string_view digits = head;
  while (!head.empty() && is_digit(head.back())) head.remove_suffix(1);
  digits.remove_prefix(head.size());

  std::string symbol = head.size() == 1 ? plain(head) : greek(head);
  if (symbol.empty()) {
    const std::string word = plain(text);
    return (operation ? "\\operatorname{" : "\\mathit{") + word + "}";
  }
  std::string below = plain(digits);
  if (underscore != std::string_view::npos) {
    if (!below.empty()) below += ",";
    below += subscript(text.substr(underscore + 1));
  }
  return below.empty() ? symbol : symbol + "_{" + below + "}";
}

}  // namespace

std::string latex_name(std::string_view name, bool operation) {
  std::string out;
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find('.', begin), name.size());
    std::string text(name.substr(begin, end - begin));
    const auto primes = static_cast<std::size_t>(std::ranges::count(text, '\''));
    std::erase(text, '\'');
    out += (begin > 0 ? "." : "") + part(text, operation && end == name.size()) +
           std::string(primes, '\'');
    begin = end + 1;
  }
  return out;
}

std::string latex_text(std::string_view text) {
  std::string out = "\\text{";
  for (std::size_t at = 0; at < text.size();) {
    const text::CodePoint point = text::decode(text, at);
    const char c = point.value < 0x80 ? static_cast<char>(point.value) : '\0';
    const std::string letter = point.length > 1 ? greek(greek_name(point.value)) : "";
    at += std::max<std::size_t>(point.length, 1);
    if (is_letter(c) || is_digit(c) ||
        (c != '\0' &&
         std::string_view(" .,;:!?()[]/+-*='`@").find(c) != std::string_view::npos))
      out += c;
    else if (c != '\0' && std::string_view("_%&#${}").find(c) != std::string_view::npos)
      out += std::string("\\") + c;
    else if (c == '\\')
      out += "\\textbackslash{}";
    else if (c == '^')
      out += "\\textasciicircum{}";
    else if (c == '~')
      out += "\\textasciitilde{}";
    else if (c == '"')
      out += "''";
    else if (c == '<' || c == '>' || c == '|')
      out += std::string("}") + c + "\\text{";
    else if (!letter.empty())
      out += "}" + letter + "\\text{";
    else
      out +=
          "[" + (point.length == 0 ? std::string("byte") : text::code_name(point.value)) + "]";
  }
  return out + "}";
}

}  // namespace seam::claims
