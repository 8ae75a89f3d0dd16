// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "certificate/evidence.h"
#include "check/tower.h"

namespace seam::check {

/// A statement and its evidence as numbers and polynomials: what all rules work with.
/// Symbols are numbered: generators of the statement, those of the evidence, variables.
/// Requires that neither has a `certificate::fault`; keeps references to both.
class Context {
 public:
  /// Accepts every generator, or throws `Open`: also where a name stands for two things.
  Context(const certificate::Statement&, const certificate::Evidence&, Meter&);

  Meter& meter() { return *meter_; }
  Ring& ring() { return ring_; }
  Tower& tower() { return tower_; }

  /// The normal form of a term.
  Polynomial value(certificate::Term);
  /// The same; throws `Open` if it holds a variable.
  Polynomial number(certificate::Term);
  Polynomial rational(const std::string& text) { return parse_rational(text, *meter_); }

  /// The symbol of a variable. Throws `Open` if the name is none of a variable.
  int variable(const std::string& name) const;
  std::set<int> variables(const std::vector<std::string>& names) const;
  /// From this symbol on, none stands in a formula.
  int free_symbol() const { return static_cast<int>(symbols_.size()); }
  /// Whether it holds, beside numbers, these symbols alone.
  bool depends_only_on(const Polynomial&, const std::set<int>& variables) const;

 private:
  const certificate::Node& node(certificate::Term) const;
  void name_symbols();
  void accept_generators();
  Polynomial evaluated(const certificate::Node&);

  const certificate::Statement* statement_;
  const certificate::Evidence* evidence_;
  Meter* meter_;
  Ring ring_;
  Tower tower_;
  std::map<std::string, int> symbols_;
  int generators_ = 0;
  std::vector<std::optional<Polynomial>> known_;
  std::size_t known_words_ = 0;
};

}  // namespace seam::check
