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
/// Symbols are numbered: generators of the statement, those of the evidence, variables,
/// functions. Every value is in normal form also with respect to
///     function^degree = radicand,
/// of sin(a)^2 = 1 - cos(a)^2, and so stands for the term wherever the functions in it have a
/// value.
/// Requires that neither has a `certificate::fault`; keeps references to both.
class Context {
 public:
  /// Accepts every generator and function, or throws `Open`: also where a name stands for two
  /// things.
  Context(const certificate::Statement&, const certificate::Evidence&, Meter&);

  Meter& meter() { return *meter_; }
  Ring& ring() { return ring_; }
  Tower& tower() { return tower_; }

  /// Where the obligation that is looked at fails, in words, if its rule says so.
  std::string failed_at;

  /// The normal form of a term.
  Polynomial value(certificate::Term);
  /// The same; throws `Open` if it holds a variable.
  Polynomial number(certificate::Term);
  Polynomial rational(const std::string& text) { return parse_rational(text, *meter_); }

  /// The functions that stand in these terms, and in the operands of such; with a sine the
  /// cosine that its rule brings in.
  std::set<int> functions(std::vector<certificate::Term>) const;
  const certificate::Function& function(int index) const;
  const Polynomial& operand(int function) const;
  /// Of the same operand, if the function is a sine that has a rule.
  std::optional<int> cosine(int function) const;

  /// The symbol of a variable or a function. Throws `Open` if the name is none.
  int variable(const std::string& name) const;
  std::set<int> variables(const std::vector<std::string>& names) const;
  /// The symbols in it that are no generators.
  std::set<int> variables(const Polynomial&) const;
  /// From this symbol on, none stands in a formula.
  int free_symbol() const { return static_cast<int>(symbols_.size()); }
  /// Whether it holds, beside numbers, these symbols alone.
  bool depends_only_on(const Polynomial&, const std::set<int>& variables) const;

 private:
  const certificate::Node& node(certificate::Term) const;
  void name_symbols();
  void accept_generators();
  void accept_functions();
  void add_cosine(int sine);
  Polynomial evaluated(const certificate::Node&);

  const certificate::Statement* statement_;
  const certificate::Evidence* evidence_;
  Meter* meter_;
  Ring ring_;
  Tower tower_;
  std::map<std::string, int> symbols_;
  int generators_ = 0;
  int first_function_ = 0;
  std::vector<Polynomial> operands_;
  std::map<int, int> cosines_;
  std::vector<std::optional<Polynomial>> known_;
  std::size_t known_words_ = 0;
};

}  // namespace seam::check
