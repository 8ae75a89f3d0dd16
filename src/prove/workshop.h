// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "exact/roots.h"
#include "prove/prove.h"

namespace seam::prove {

/// The statement is not well formed: a symbol is neither number nor variable of its obligation.
struct Unfit : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A statement being worked on: its numbers as a tower, its terms as polynomials, and the
/// evidence as it is written. Numbers that a proof needs beyond those of the statement become
/// generators of the evidence, so the tower may grow; rings made before stay valid, over the
/// tower of their time.
///
/// A transcendental number is a variable where a ring has it, and else a rational near it: what
/// is found with that is tried, and judged with the number itself.
class Workshop {
 public:
  Workshop(const certificate::Statement&, certificate::Evidence&, const Budget&);

  const certificate::Statement& statement() const { return *statement_; }
  const Budget& budget() const { return *budget_; }
  bool late() const { return std::chrono::steady_clock::now() >= budget_->deadline; }

  const exact::TowerPtr& tower() const { return tower_; }
  exact::RingPtr numbers() const { return ring({}); }
  /// Over the present tower.
  exact::RingPtr ring(const std::vector<std::string>& variables) const;

  /// The transcendental numbers of the statement.
  const std::vector<std::string>& transcendental() const { return transcendental_; }

  /// The functions that stand in these terms, and in the operands of such, in their order; with
  /// a sine the cosine of the same operand.
  std::vector<const certificate::Function*> functions(
      const std::vector<certificate::Term>&) const;
  /// The cosine of the same operand, if the function is a sine and the statement has it.
  std::optional<std::string> cosine(const certificate::Function&) const;
  /// The variables of a term, and of the radicands of its functions.
  std::set<std::string> variables(certificate::Term) const;
  /// A term as an element of the ring in these variables and functions; they hold all of the
  /// term's. In normal form, as `reduced` makes it.
  exact::Polynomial expand(certificate::Term, const std::vector<std::string>& variables);
  exact::Polynomial number(certificate::Term term) { return expand(term, {}); }

  /// No function in the degree of its root or above, no square of a sine beside its cosine. The
  /// ring is one over the present tower.
  exact::Polynomial reduced(exact::Polynomial);
  exact::Polynomial power(const exact::Polynomial&, int exponent);

  /// The root as a number over the present tower, which grows by it if need be. The polynomial
  /// is squarefree.
  exact::Polynomial adjoin(const exact::Univariate& squarefree, const exact::RootInterval&);

  /// A number near the value of an elementary function. The operand is a polynomial in
  /// transcendental numbers of the statement. Nothing where the function has no value.
  std::optional<exact::Polynomial> near_value(certificate::Elementary,
                                              const exact::Polynomial& operand);
  /// Whether that is the value: a rational, without a new number.
  static bool is_simple(certificate::Elementary, const exact::Polynomial& operand);

  /// Terms of the evidence.
  certificate::Term write(const exact::Rational&);
  certificate::Term write(const exact::Polynomial&);
  /// The value itself.
  certificate::Term write(certificate::Elementary, const exact::Polynomial& operand);
  certificate::Term negated(certificate::Term);

 private:
  using Key = std::vector<std::string>;
  /// A sine, and the cosine of the same operand, of the statement.
  struct Circle {
    std::string sine, cosine;
  };
  void accept(const certificate::Generator&);
  void add_circles();
  exact::Polynomial without_squares(exact::Polynomial);
  std::optional<exact::Rational> near(certificate::Elementary, const exact::Polynomial& at);
  certificate::Term add(certificate::Node);

  const certificate::Statement* statement_;
  certificate::Evidence* evidence_;
  const Budget* budget_;
  exact::TowerPtr tower_;
  std::set<std::string> generators_;
  std::vector<std::string> transcendental_;
  std::map<std::string, exact::Rational> near_;  ///< the transcendental numbers
  std::vector<Circle> circles_;
  std::vector<std::set<std::string>> symbols_;  ///< of each node of the statement
  mutable std::map<Key, exact::RingPtr> rings_;
  std::map<Key, std::map<certificate::Term, exact::Polynomial>> expanded_;
  std::map<std::string, certificate::Term> written_;  ///< by the text of the node
};

}  // namespace seam::prove
