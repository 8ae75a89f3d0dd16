// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "claims/mutation.h"

namespace seam::claims {

/// A name, and the item that gives it.
struct KnownName {
  std::string name;
  const Item* item = nullptr;
};

/// Where a node stands.
struct NodeContext {
  const std::vector<KnownName>* known = nullptr;  ///< by earlier items
  std::vector<std::string> bound = {};            ///< by quantifiers, lists, headers round it
  const Expression* parent = nullptr;             ///< none: it is the whole expression
  std::size_t child = 0;                          ///< of the parent
  bool is_set = false;                            ///< it is the set of a binding or parameter
  bool is_in_set = false;                         ///< its parent is
};

/// What else may stand where this node stands.
using NodeMutants = std::vector<std::pair<Mutation::Kind, Expression>>;
NodeMutants mutants_of_node(const Expression&, const NodeContext&);

/// The other words of the language that take the same arguments: those of `sin` are `cos` and
/// `exp`.
std::vector<std::string> words_like(const std::string& word);

}  // namespace seam::claims
