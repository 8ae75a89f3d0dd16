// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/words.h"

#include <algorithm>

// Words that only ever stand where no name can (`at`, `all`, `digits`, `labelled`, ...)
// are not reserved; a paper may need them as names.

namespace seam::claims {
namespace {

const std::vector<std::string>& value_words() {
  static const std::vector<std::string> words = {
      "curve", "from",       "infinity", "none", "one",
      "plane", "quad_patch", "rational", "read", "triangle_patch"};
  return words;
}

std::vector<std::string> all_reserved() {
  std::vector<std::string> all;
  for (const auto* words : {&item_words(), &clause_words(), &operator_words(), &value_words()})
    all.insert(all.end(), words->begin(), words->end());
  std::ranges::sort(all);
  return all;
}

}  // namespace

const std::vector<std::string>& item_words() {
  static const std::vector<std::string> words = {"paper", "section", "let",     "sequence",
                                                 "param", "root",    "include", "define",
                                                 "claim", "table",   "figure",  "ask"};
  return words;
}

const std::vector<std::string>& clause_words() {
  static const std::vector<std::string> words = {"corrected", "expect", "using", "by"};
  return words;
}

const std::vector<std::string>& operator_words() {
  static const std::vector<std::string> words = {"and",   "or",    "not",      "implies",
                                                 "iff",   "for",   "in",       "where",
                                                 "solve", "gives", "truncated"};
  return words;
}

const std::vector<std::string>& figure_clauses() {
  static const std::vector<std::string> words = {"coloured", "with", "for"};
  return words;
}

const std::vector<std::string>& figure_parts() {
  static const std::vector<std::string> words = {"net", "curvature_lines", "contours"};
  return words;
}

bool reserved(std::string_view word) {
  static const std::vector<std::string> words = all_reserved();
  return std::ranges::binary_search(words, word);
}

}  // namespace seam::claims
