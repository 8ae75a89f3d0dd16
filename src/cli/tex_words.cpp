// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/tex_words.h"

#include <algorithm>

namespace seam::cli {

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '@';
}
bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

bool among(const std::string& word, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

bool is_verbatim(const std::string& environment) {
  return among(environment, {"verbatim", "verbatim*", "Verbatim", "Verbatim*", "BVerbatim",
                             "lstlisting", "minted", "comment"});
}

bool defines(const std::string& word) {
  return among(word, {"newcommand", "renewcommand", "providecommand", "DeclareRobustCommand",
                      "def", "gdef", "edef", "xdef", "let", "protected@edef"});
}

// A carriage return alone ends a line for TeX, too.
std::string with_line_ends(std::string text) {
  for (std::size_t i = 0; i < text.size(); ++i)
    if (text[i] == '\r') text[i] = i + 1 < text.size() && text[i + 1] == '\n' ? ' ' : '\n';
  return text;
}

std::string trimmed(std::string text) {
  while (!text.empty() && is_blank(text.back())) text.pop_back();
  text.erase(0, std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  return text;
}

// The conditionals of TeX itself; what \newif makes is added where it is made.
bool is_conditional(const std::string& word, const std::set<std::string>& made) {
  return among(word,
               {"if",      "ifcat",   "ifx",     "ifnum",     "ifdim",    "ifodd",     "ifcase",
                "ifvmode", "ifhmode", "ifmmode", "ifinner",   "ifvoid",   "ifhbox",    "ifvbox",
                "ifeof",   "iftrue",  "iffalse", "ifdefined", "ifcsname", "iffontchar"}) ||
         made.contains(word);
}

}  // namespace seam::cli
