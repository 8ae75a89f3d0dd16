// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "claims/extremum_search.h"
#include "claims/state.h"

// The parts of `state`, each in a file of its own: relation.cpp, quantifier.cpp,
// predicate.cpp, extremum.cpp, minimax.cpp, solve.cpp.
namespace seam::claims {

using symbolic::Proposition;
using symbolic::Relation;

/// An assumption: the constraints hold for all values of the variables.
struct Assumption {
  std::vector<std::string> variables;
  std::vector<symbolic::Constraint> constraints;
};

/// The universal quantifiers around a statement: its variables range over the product of the
/// factors, over all reals for `lines`, where all the constraints hold; under the assumptions
/// `given`; with `functions`: for all arbitrary functions of the file.
struct Context {
  std::vector<symbolic::Simplex> factors;
  std::vector<std::string> lines;
  std::vector<symbolic::Constraint> where;
  std::vector<Assumption> given;
  bool functions = false;

  bool empty() const {
    return factors.empty() && lines.empty() && is_unconditional() && !functions;
  }
  bool is_unconditional() const { return where.empty() && given.empty(); }
};

/// A point inside the context and the sets of the parameters of the file; another one for
/// another weight > 0.
std::map<std::string, Formula> sample(const Context&, Evaluator&, long weight);

class Stating {
 public:
  explicit Stating(Evaluator& e) : evaluator(e) {}

  /// The statement, or with `positive` false its negation, for all points of the context.
  Proposition state(const Expression&, const Scope&, const Context&, bool positive = true);

  // relation.cpp, comparison.cpp
  Proposition relation(const Expression&, const Scope&, const Context&, bool positive);
  Proposition approximation(const Expression&, const Value& left, const Expression& printed,
                            bool truncated, const Context&, bool positive);
  /// The formula has the relation to 0 on all of the context; parameters of the file are added
  /// to it.
  Proposition holds(const Formula&, Relation, const Context&, const Expression& at,
                    const std::string& about = {});
  /// States as guards what a value rests on: divisors that are not 0, radicands not negative.
  void guard(const Scalar&, const Context&, const Expression& at);
  /// What these variables and those of the conditions range over; all reals in halves.
  std::vector<symbolic::Domain> domains(const std::set<std::string>& variables, const Context&,
                                        const Expression& at);
  /// `a operation b` as `formula relation 0`, with guards for the divisors.
  symbolic::Constraint related(const Scalar& difference, Relation, const Context&,
                               const Expression& at);
  symbolic::Constraint compared(const Scalar& a, const std::string& operation, const Scalar& b,
                                const Context&, const Expression& at);
  /// A statement as a conjunction of constraints, if it is one.
  std::optional<std::vector<symbolic::Constraint>> constraints(const Expression&, const Scope&,
                                                               const Context&, bool positive);
  /// Adds a statement to the conditions of a context; false where it is none that fits.
  bool assume(const Expression&, const Scope&, Context&, bool positive);

  // independent.cpp
  /// A formula and its context with every arbitrary function, at each argument and in each
  /// order of derivation, as a real variable of its own.
  struct Independent {
    Formula formula;
    Context context;
    /// What fails for some values of the variables fails for some functions.
    bool is_exact = true;
  };
  Independent independent(const Formula&, const Context&);

  // settle.cpp
  /// A proposition about a patch or a point, whose formulas may hold quotients, roots and
  /// variables of the context, as one for all of the context, with guards for what its formulas
  /// rest on.
  Proposition settled(Proposition, const Context&, const Expression& at);

  // quantifier.cpp
  Proposition quantified(const Expression&, const Scope&, const Context&, bool positive);
  Proposition alternatives(const std::vector<std::pair<const Expression*, bool>>&, const Scope&,
                           const Context&);

  // predicate.cpp
  Proposition called(const Expression&, const Scope&, const Context&, bool positive);
  Proposition some_nonzero(const std::vector<Formula>&, const Context&, const Expression& at);

  // blending.cpp
  /// Predicates of lists of functions.
  static bool is_about_functions(const Expression& call);
  Proposition about_functions(const Expression& call, const Scope&, const Context&);

  // extremum.cpp
  /// `part operation bound` everywhere; over triangles where `cut`.
  Proposition everywhere(const Expression&, const Extremum&, const std::string& operation,
                         const Scalar& bound, const Context&, bool cut);
  /// The value at the place, computed again: it is what the search says.
  void state_attained(const Expression&, const Attained&);
  /// What the claim follows from, though it may fail where the claim holds; so nothing is
  /// refuted by it. It is a conjunction.
  Proposition sufficient(Proposition);
  /// What refutes the claim, though the claim may fail without it; so nothing is proven by it.
  Proposition refuting(Proposition);

  // solve.cpp
  Proposition solved(const Expression&, const Scope&, const Context&);

  Evaluator& evaluator;
  std::vector<Proposition> guards;
  std::set<std::string> predicates;
  bool speaks_of_functions = false;  ///< arbitrary ones

 private:
  /// A domain, and variables beside it that range over all reals.
  struct Range {
    symbolic::Domain domain;
    std::vector<std::string> lines;
  };
  Range range(const std::set<std::string>& variables, const Context&, const Expression& at);
  static std::vector<symbolic::Domain> halved(const Range&);
  /// The same points with fewer variables and conditions, where equations and bounds of `lines`
  /// allow it. (lines.cpp)
  void simplify(Formula&, Range&) const;
  /// Takes conditions about numbers out of the context, each with a guard that it holds; or
  /// says that one fails: then there is no point to speak of.
  std::optional<Proposition> take_numbers(Context&);
  Proposition continuous(const Expression& call, const Scope&, const Context&);
  Proposition holds_for_all(const Formula&, Relation, const Context&, const Expression& at,
                            const std::string& about);
  Proposition compare(const Expression&, const Value& a, const std::string& operation,
                      const Value& b, const Context&, bool positive);
  Proposition compare_extremum(const Expression&, const Extremum&, const std::string& operation,
                               const Scalar&, const Context&);
  Proposition reached(const Expression&, const Extremum&, const std::string& operation,
                      const Scalar&, const Context&);
  Proposition compare_minimax(const Expression&, const Minimax&, const std::string& operation,
                              const Scalar&, const Context&);
  Proposition best_choice(const Expression&, const Minimax&, const Formula& value);
  Proposition entries(const Expression&, const std::vector<Value>& a,
                      const std::vector<Value>& b, const std::string& operation, const Context&,
                      bool positive);
  std::optional<exact::Sign> likely_sign(const Formula&, const Context&);
  /// That it is not 0, with the sign it seems to have, which is returned.
  std::optional<exact::Sign> guard_divisor(const Formula&, const Context&,
                                           const Expression& at);
  void guard_roots(const Formula&, const Context&, const Expression& at);
  std::optional<exact::Sign> guard_denominator(const Formula&, const Context&,
                                               const Expression& at);
};

/// What is stated of the formula of a comparison is measured by the difference of its sides.
Proposition measured(Proposition, const symbolic::Constraint&, const std::string& unit);
/// What is measured, in units of this size.
Proposition in_units(Proposition, const Formula& size, const std::string& unit);

/// The numbers that a printed decimal is a correct rounding of: half a unit of its last digit
/// to either side.
std::pair<exact::Rational, exact::Rational> printed_range(const Expression& printed);

/// The variables of the formulas of zeros, signs, tuples and systems in several unknowns.
std::set<std::string> variables_of(const Proposition&);

std::vector<std::string> predicate_names();

std::string negated_operation(const std::string& operation);

}  // namespace seam::claims
