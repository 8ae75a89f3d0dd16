// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "exact/polynomial.h"
#include "symbolic/formula.h"

namespace seam::symbolic {

/// A number was asked for that does not exist: the root of a negative number, a quotient by 0,
/// no root or several in an interval. The message says which.
struct NumberError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A number field would become too large to compute in (degree over 64), or a transcendental
/// number was not told from 0.
struct NumberLimit : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The real numbers of one file: generators (roots of polynomials over earlier ones, values of
/// elementary functions) and exact decisions about formulas without variables ("number
/// formulas").
///
/// Every decision is made in the field of just those generators that the numbers in question
/// hold. In it each generator is either a further root, its polynomial factored over those
/// before, or expressed by them. So a number is 0 exactly when its normal form is, and what a
/// file holds besides costs nothing. Results are `known` formulas whose facts say what they
/// are. Deterministic.
///
/// Values of exp, log, sin, cos and pi are taken for independent of each other, but for
/// sin^2 + cos^2 = 1: a normal form 0 means 0, any other is told from 0 by enclosures, and
/// where these do not tell, `NumberLimit` is thrown.
class Numbers {
 public:
  Numbers();
  ~Numbers();
  Numbers(Numbers&&) noexcept;
  Numbers& operator=(Numbers&&) noexcept;

  /// The root >= 0 of x^n = radicand (the real one if n is odd). n >= 2.
  Formula nth_root(const Formula& radicand, int n);
  Formula sqrt(const Formula& radicand) { return nth_root(radicand, 2); }

  /// The only real root in [low, high] of a polynomial in `unknown` with number coefficients.
  Formula root(const Formula& polynomial, const std::string& unknown,
               const exact::Rational& low, const exact::Rational& high);

  /// 1/x as a formula that is a polynomial in the generators; fact: x * inverse - 1 = 0.
  Formula inverse(const Formula& x);

  /// The value of `exp`, `log`, `sin` or `cos` at a number, as a generator.
  Formula elementary(const std::string& function, const Formula& argument);
  Formula pi();
  /// cos(multiple * pi), an algebraic number.
  Formula cosine_of_pi(const exact::Rational& multiple);
  /// Whether no value of such a function is left in normal form.
  bool is_algebraic(const Formula& number) const;

  exact::Sign sign(const Formula& number) const;
  bool equal(const Formula& a, const Formula& b) const;
  bool equal(const Point& a, const Point& b) const;
  std::optional<exact::Rational> rational(const Formula& number) const;  ///< if it is one

  /// The same number, reduced to normal form in the generators (a polynomial with rational
  /// coefficients).
  Formula normal_form(const Formula& number) const;

  double approximate(const Formula& number) const;
  /// [low, high] around the number, high - low <= width.
  std::pair<exact::Rational, exact::Rational> enclosure(const Formula& number,
                                                        const exact::Rational& width) const;
  /// Correctly rounded to `digits` after the point: `0.618034`.
  std::string decimal(const Formula& number, int digits) const;

  struct Generator {
    std::string name;           ///< `sqrt(5)`, `root(3*g^3 - g - 1)`; unique
    Formula polynomial;         ///< in Formula::symbol(name), over earlier generators
    exact::Rational low, high;  ///< holds this root of the polynomial, no other, and not as an
                                ///< end where a sign change could not show it
    std::string function;       ///< or: `exp`, `log`, `sin`, `cos`, `pi` ...
    Formula argument;           ///< ... of this; `inverse`, beside the polynomial: 1 / this
  };

  /// The generator of that name, if it is one.
  const Generator* find(const std::string& name) const;
  const std::vector<Generator>& generators() const;  ///< all, in the order they were made

  /// The field of some generators, and of those that they are defined by.
  struct Field {
    exact::RingPtr ring;                              ///< no variables
    std::vector<Generator> generators;                ///< of its tower, irreducible in turn
    std::map<std::string, exact::Polynomial> values;  ///< of all generators, in the ring
    std::map<std::string, Formula> dependent;  ///< those of no step, by the others; known
    std::vector<Generator> transcendental;     ///< with a function; each after its argument
  };
  /// Of the generators among these symbols.
  const Field& field(const std::set<std::string>& symbols) const;
  const Field& field(const Formula& number) const;

 private:
  Formula transcendental_inverse(const Formula&);
  struct Forest;
  std::unique_ptr<Forest> forest_;
};

}  // namespace seam::symbolic
