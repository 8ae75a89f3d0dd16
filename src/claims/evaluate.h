// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "claims/integers.h"
#include "claims/value.h"
#include "symbolic/proposition.h"

namespace seam::claims {

/// Something in the file is wrong: unwinds to the item, which is then reported and left out.
struct Problem : std::runtime_error {
  explicit Problem(text::Diagnostic d)
      : std::runtime_error(d.message), diagnostic(std::move(d)) {}
  text::Diagnostic diagnostic;
};
[[noreturn]] void fail(const Expression& at, std::string message, std::string hint = {});

/// An item rests on one that was reported already.
struct Broken : std::runtime_error {
  Broken() : std::runtime_error("rests on an item with an error") {}
};

/// A statement that means something, of a kind that this version has no proof for; or one that
/// takes more time or memory to read than was given.
struct Unsupported : std::runtime_error {
  explicit Unsupported(const std::string& detail, std::string why = "unsupported")
      : std::runtime_error(detail), reason(std::move(why)) {}
  std::string reason;  ///< that of an undecided claim
};

/// An integer parameter that has no value where one is wanted.
struct IntegerMet : Unsupported {
  explicit IntegerMet(std::string met)
      : Unsupported("an integer parameter outside a claim"), parameter(std::move(met)) {}
  std::string parameter;
};

/// What a name stands for between two braces of the text: values bound by quantifiers,
/// functions and lists.
struct Scope {
  const Scope* outer = nullptr;
  std::map<std::string, Value> values;
};

/// A global name. `sides` are statements that its value rests on (what a count or an extremum
/// claims).
struct Definition {
  const Item* item = nullptr;
  std::optional<Value> value;  ///< none: a function, or broken
  std::vector<symbolic::Proposition> sides;
  bool broken = false;
  std::string unsupported;             ///< why no claim about it can be decided; empty: nothing
  std::string reason = "unsupported";  ///< with that
  bool holds_integers = false;  ///< its value is another one for each of an integer parameter
};

/// One parameter of the file: a symbol with its set, and the conditions that hold it.
struct Parameter {
  std::string name;
  std::optional<symbolic::Simplex> set;  ///< none: every real number
  std::vector<symbolic::Constraint> where;
};

/// Turns expressions into values. Everything is exact; nothing is decided except about numbers
/// (through `Numbers`), and what rests on such a decision says so in facts or in `sides`.
///
/// Always ends: a function can only call what is defined before it, and the total number of
/// steps is bounded.
class Evaluator {
 public:
  explicit Evaluator(Numbers& tower) : numbers(tower) {}

  Value evaluate(const Expression&, const Scope&);

  Scalar scalar(const Expression&, const Scope&);
  Formula number(const Expression&, const Scope&);  ///< a value without variables
  long integer(const Expression&, const Scope&);

  /// A symbol for a variable that is bound at `at`; its name is the written one unless that is
  /// in use around it.
  std::string bind(const std::string& name);
  void release(const std::string& symbol) { active_.erase(symbol); }
  /// The symbols that are bound, and a way back to those that were.
  const std::set<std::string>& bound_symbols() const { return active_; }
  void bind_only(std::set<std::string> symbols) { active_ = std::move(symbols); }

  /// The value of a number that is wanted itself, where `value` is an extremum: found, and
  /// stated in `sides`.
  Value resolved(const Value&, const Expression& at);

  /// The values that a finite set (a list, a range) holds, or nothing if the expression is no
  /// such set.
  std::optional<std::vector<Value>> finite_set(const Expression&, const Scope&);
  /// `[0, 1]`, `(0, 1)`, `[0, 1)`: two ends that are numbers or infinite (a list of two numbers
  /// is an interval).
  bool is_interval(const Expression&, const Scope&);
  /// The set that a binding ranges over, for symbols already bound. One simplex a group of
  /// names.
  symbolic::Simplex continuous_set(const Expression& set,
                                   const std::vector<std::string>& symbols, const Scope&);

  /// Known names near to a misspelt one.
  std::vector<std::string> names(const Scope&) const;

  Numbers& numbers;
  std::map<std::string, Definition> globals;
  std::vector<Parameter> parameters;
  std::vector<std::string> any_meshes;  ///< parameters that stand for any mesh
  Integers integers;
  std::vector<std::pair<Formula, std::string>> jets;  ///< see Stating::independent
  std::map<std::string, std::size_t> sums;            ///< up to integer parameters, numbered
  std::set<std::string> hidden;  ///< parameters that unknown values of sequences and sums hold
  std::multiset<std::string> varied;            ///< variables that arguments name at present
  std::vector<symbolic::Proposition> sides;     ///< of what is being evaluated
  std::vector<symbolic::Proposition> standing;  ///< of the values around the statement
  std::string folder;                           ///< for `read`: the folder of the file

 private:
  Value name(const Expression&, const Scope&);
  Value call(const Expression&, const Scope&);
  Value apply(const Value& callee, const Expression& at, const Scope&);
  Value index(const Expression&, const Scope&);
  Value list(const Expression&, const Scope&);
  Value matrix(const Expression&, const Scope&);
  Value with_integers(const std::string& name, const Item&);
  Value net(const Expression&, const Scope&);

  std::set<std::string> active_;
  long steps_ = 0;
  int depth_ = 0;
};

/// The set and the `where` condition of a binding; null where it has none.
const Expression* set_of(const Expression& binding);
const Expression* condition_of(const Expression& binding);

/// The values of `E for i in R, ...`, in order.
std::vector<Value> comprehension(Evaluator&, const Expression& each, const Scope&);

/// The value of a sequence at an index: worked out from its start on, or, where the index is an
/// integer parameter, a symbol for each entry.
Value sequence_value(Evaluator&, const Item& sequence, const Scalar& index,
                     const Expression& at);

/// The sum of `E for i in low..high` where `high` is an integer parameter, perhaps shifted;
/// nothing if it is none.
std::optional<Value> sum_to_parameter(Evaluator&, const Expression& each, const Scope&);

/// + - * / ^ on values of all kinds. Throws `Problem` where they do not fit.
Value arithmetic(Evaluator&, const Expression& at, const std::string& operation, const Value&,
                 const Value&);
Value negated(Evaluator&, const Expression& at, const Value&);

/// The function of that name that the language brings along, applied to the arguments of the
/// call `at`; nothing if there is none.
std::optional<Value> builtin(Evaluator&, const std::string& name, const Expression& at,
                             const Scope&);
std::vector<std::string> builtin_names();
/// A word that is a value: `tetrahedron`, `triangle`.
std::optional<Value> builtin_word(Evaluator&, const std::string& name);

// Conversions, with an error at `at` where a value is of another kind.
Scalar as_scalar(Evaluator&, const Value&, const Expression& at);
Formula as_formula(Evaluator&, const Value&, const Expression& at);
Formula as_number(Evaluator&, const Value&, const Expression& at);
long as_integer(Evaluator&, const Value&, const Expression& at);
Vector as_vector(Evaluator&, const Value&, const Expression& at);
symbolic::Point as_point(Evaluator&, const Value&, const Expression& at);
std::vector<Value> as_items(Evaluator&, const Value&, const Expression& at);
std::vector<symbolic::Point> as_points(Evaluator&, const Value&, const Expression& at);
geometry::Matrix as_matrix(Evaluator&, const Value&, const Expression& at);

Value vector_value(const symbolic::Point&, Numbers&);
exact::Rational decimal(const std::string& digits);  ///< `0.25`

}  // namespace seam::claims
