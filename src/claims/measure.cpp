// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/measure.h"

#include <algorithm>
#include <set>
#include <string>

namespace seam::claims {

symbolic::Measure measure_of(const symbolic::Atom& atom) {
  const auto* sign = std::get_if<symbolic::Sign>(&atom);
  return sign ? sign->measure : symbolic::Measure{};
}

bool speaks_of(const certificate::Statement& statement, const symbolic::Formula& formula) {
  if (!formula.is_polynomial()) return false;
  std::set<std::string> known;
  for (const certificate::Node& node : statement.nodes)
    if (node.kind == certificate::Node::Kind::symbol) known.insert(node.text);
  return std::ranges::all_of(symbolic::symbols(formula),
                             [&](const std::string& name) { return known.contains(name); });
}

}  // namespace seam::claims
