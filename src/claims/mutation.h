// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "claims/syntax.h"

namespace seam::claims {

/// One small change of a file: at one place of one tree something else stands.
struct Mutation {
  enum class Kind {
    number,      ///< one more or less, in its last digit
    power,       ///< an exponent, one more or less
    sign,        ///< a minus that was not there, or is there no more
    operation,   ///< + - * / ^
    relation,    ///< = != < <= > >= ~
    connective,  ///< and, or, not, implies, iff, for all, for some; a part left out
    name,        ///< another definition, or another bound name
    function,    ///< another function, predicate or solid of the language
    index,       ///< of an entry, one more or less
    range,       ///< an end of a set or a range, or whether it belongs to it
    order        ///< two neighbours exchanged
  };
  static constexpr std::array words = {"number",   "power",      "sign", "operation",
                                       "relation", "connective", "name", "function",
                                       "index",    "range",      "order"};

  Kind kind = Kind::number;
  std::size_t item = 0;                ///< in the file
  std::size_t part = 0;                ///< of `expressions_of` the item
  std::vector<std::size_t> path = {};  ///< from there on, from child to child
  Expression instead = {};

  const char* word() const { return words[static_cast<std::size_t>(kind)]; }
};

/// Every mutation of the file's definitions and claims, in the order of their places.
std::vector<Mutation> mutations(const File&);

/// The file with that change, and nothing else changed.
File mutated(const File&, const Mutation&);

/// What a reader is shown of it: the widest expression round the place that is short enough to
/// be taken in at a glance, before and after.
struct Difference {
  text::Span where;  ///< the place itself
  std::string before, after;
};
Difference difference(const File&, const Mutation&);

}  // namespace seam::claims
