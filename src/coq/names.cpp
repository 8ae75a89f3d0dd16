// SPDX-License-Identifier: GPL-3.0-or-later
#include "coq/names.h"

#include <algorithm>
#include <array>
#include <cctype>

// What Coq or the library calls something is taken: a bound name would hide it.

namespace seam::coq {
namespace {

constexpr std::array words = {
    "I",        "R",       "Q",           "Z",           "C",        "S",      "O",
    "N",        "PI",      "as",          "at",          "cofix",    "conj",   "do",
    "else",     "end",     "eq_refl",     "exists",      "fix",      "forall", "fun",
    "if",       "IF",      "in",          "is",          "let",      "match",  "mod",
    "nat",      "of",      "open",        "pow",         "Prop",     "return", "roots",
    "SProp",    "Set",     "then",        "Type",        "using",    "where",  "with",
    "list",     "Num",     "Frac",        "Sym",         "Add",      "Sub",    "Mul",
    "Opp",      "Pow",     "Plain",       "Split",       "Outside",  "Zero",   "Positive",
    "Negative", "Nonzero", "Nonnegative", "Nonpositive", "Generator"};

}  // namespace

std::string as_identifier(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const bool is_plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (is_plain)
      result += c;
    else if (!result.empty() && result.back() != '_')
      result += '_';
  }
  while (!result.empty() && result.back() == '_') result.pop_back();
  if (result.empty() || std::isdigit(static_cast<unsigned char>(result.front())) != 0)
    result.insert(0, "x_");
  return result;
}

std::string Names::fresh(const std::string& wish) {
  const auto is_free = [&](const std::string& name) {
    return std::ranges::find(words, name) == words.end() && !taken_.contains(name);
  };
  std::string name = wish;
  for (int i = 1; !is_free(name); ++i) name = wish + "_" + std::to_string(i);
  taken_.insert(name);
  return name;
}

const std::string& Names::of(const std::string& symbol) {
  const auto found = known_.find(symbol);
  if (found != known_.end()) return found->second;
  return known_.emplace(symbol, fresh(as_identifier(symbol))).first->second;
}

}  // namespace seam::coq
