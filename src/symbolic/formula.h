// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "exact/rational.h"

namespace seam::symbolic {

struct Fact;

/// A formula was about to be nested deeper than any walk should go (5000 levels), or to hold a
/// constant of more than a million bits.
struct FormulaLimit : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An expression in named symbols (variables, parameters, generators), as it was written: an
/// immutable shared tree, never expanded. Building costs O(1); only constants are folded.
///
/// Most formulas are polynomials. A quotient is a product with an `inverse`; `root` is the root
/// >= 0 of a function (an even index). Either has a value only where its operand is not 0, not
/// negative: whoever states something of such a formula states that too. `applied` is a named
/// function of its operands: `sin`, `cos`, `exp`, `log` are what they are called; any other
/// name stands for an arbitrary smooth function, of which `orders` says how often it is derived
/// in each operand.
///
/// The names of generators (numbers such as `sqrt(5)`) hold a parenthesis; those of variables
/// do not.
class Formula {
 public:
  enum class Kind { constant, symbol, sum, product, power, inverse, root, applied, known };

  Formula(long value = 0);
  explicit Formula(exact::Rational value);
  static Formula symbol(std::string name);

  /// Stands for `value`, and rests on `facts`: a quotient or a root that was worked out.
  /// Whoever exports the formula exports the facts as guards.
  static Formula known(Formula value, std::vector<Fact> facts);

  /// A function of one operand or more; `orders`: as many as operands, or none for all 0.
  static Formula applied(std::string function, std::vector<Formula> operands,
                         std::vector<int> orders = {});

  Kind kind() const;
  const exact::Rational& value() const;          ///< of a constant
  const std::string& name() const;               ///< of a symbol, an applied function
  const std::vector<Formula>& operands() const;  ///< one; of a sum, product: any number
  int exponent() const;                    ///< of a power, >= 0; the index of a root, >= 2
  const std::vector<int>& orders() const;  ///< of an applied function; one an operand
  const std::vector<Fact>& facts() const;  ///< of a known value

  bool is_constant() const { return kind() == Kind::constant; }
  bool is(long value) const;
  /// No inverse, root, applied function, no fact about variables: a polynomial as it stands.
  bool is_polynomial() const;

  /// Equal as trees. O(1) when shared or when the hashes differ.
  bool same(const Formula& other) const;
  const void* identity() const { return node_.get(); }

  friend Formula operator+(const Formula& a, const Formula& b);
  friend Formula operator-(const Formula& a, const Formula& b);
  friend Formula operator-(const Formula& a);
  friend Formula operator*(const Formula& a, const Formula& b);
  Formula& operator+=(const Formula& b) { return *this = *this + b; }
  Formula& operator-=(const Formula& b) { return *this = *this - b; }
  Formula& operator*=(const Formula& b) { return *this = *this * b; }

 private:
  struct Node;
  explicit Formula(std::shared_ptr<const Node> node) : node_(std::move(node)) {}
  friend Formula sum(std::vector<Formula>);
  friend Formula product(std::vector<Formula>);
  friend Formula power(const Formula&, int);
  friend Formula inverse(const Formula&);
  friend Formula root(const Formula&, int);
  static std::shared_ptr<Node> node(Kind, std::vector<Formula> operands, int exponent = 0);
  std::shared_ptr<const Node> node_;
};

Formula sum(std::vector<Formula> terms);
Formula product(std::vector<Formula> factors);
Formula power(const Formula& base, int exponent);  ///< exponent >= 0
Formula inverse(const Formula&);                   ///< 1/x
Formula root(const Formula& radicand, int index);  ///< index even

/// The derivative with respect to a symbol. Facts about variables stay with the values they
/// belong to; numbers have none.
Formula diff(const Formula&, const std::string& symbol);

/// Every occurrence of a symbol in the map replaced, all at once.
Formula subst(const Formula&, const std::map<std::string, Formula>&);

/// Every arbitrary function (an applied one that is not elementary) replaced, from the inside
/// out: `value` gets it with operands in which that is done.
Formula replace_functions(const Formula&,
                          const std::function<Formula(const Formula& applied)>& value);

/// The symbols that occur, generators and the names of arbitrary functions included; those in
/// facts do not count.
std::set<std::string> symbols(const Formula&);
std::set<std::string> variables(const Formula&);  ///< symbols that are not generators
bool is_number(const Formula&);                   ///< no variables
bool is_generator(const std::string& name);
/// `sin`, `cos`, `exp`, `log`.
bool is_elementary(const std::string& function);

/// Infix text, for messages: `3*u^2 + sqrt(5)*v`; past `most` bytes it breaks off with `...` (a
/// shared formula may be far longer as text).
std::string text(const Formula&, std::size_t most = 100'000);

/// f relation 0.
struct Fact {
  enum class Relation { zero, nonzero, nonnegative };
  Formula formula;
  Relation relation;
};

using Point = std::vector<Formula>;  ///< a vector of coordinates

}  // namespace seam::symbolic
