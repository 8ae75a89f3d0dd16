// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes may be printed in a report: as text, or as mathematics if they are such. Whatever
// they are, no group and no formula is left open, and no command stands there that is not known
// to do nothing but print.

#include "report/escape.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "report/mathematics.h"

using namespace seam;

namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

// Words that could read, write, define, or end something.
bool is_dangerous(std::string_view word) {
  for (const std::string_view bad :
       {"input",     "include",     "openin",        "openout",      "read",      "write",
        "immediate", "special",     "def",           "edef",         "gdef",      "xdef",
        "let",       "futurelet",   "newcommand",    "renewcommand", "catcode",   "csname",
        "endcsname", "expandafter", "loop",          "endinput",     "batchmode", "pdfliteral",
        "directlua", "usepackage",  "documentclass", "verb",         "jobname",   "uppercase",
        "lowercase"})
    if (word == bad) return true;
  return false;
}

// Braces and formulas are closed, in this order; specials stand behind a backslash.
void check(std::string_view latex, bool is_mathematics) {
  int depth = 0;
  bool in_formula = is_mathematics;
  for (std::size_t i = 0; i < latex.size(); ++i) {
    const char c = latex[i];
    if (c == '\\') {
      std::size_t end = i + 1;
      while (end < latex.size() && ((latex[end] | 32) >= 'a' && (latex[end] | 32) <= 'z'))
        ++end;
      require(end < latex.size() || end > i + 1);
      require(!is_dangerous(latex.substr(i + 1, end - i - 1)));
      i = end > i + 1 ? end - 1 : end;
      continue;
    }
    if (c == '{') ++depth;
    if (c == '}') require(--depth >= 0);
    if (c == '$') {
      require(!is_mathematics && depth == 0);
      in_formula = !in_formula;
    }
    require(c != '%' && c != '#' && c != '\0');
    require(is_mathematics || (c != '&' && c != '"' && c != '<' && c != '>' && c != '|'));
    require(in_formula || (c != '_' && c != '^'));
  }
  require(depth == 0 && in_formula == is_mathematics);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  check(report::escape(bytes), false);
  if (report::is_plain_mathematics(bytes)) check(report::mathematics(bytes), true);
  return 0;
}
