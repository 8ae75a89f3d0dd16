// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "exact/tower.h"

namespace seam::exact {

class Polynomial;
class Ring;
using RingPtr = std::shared_ptr<const Ring>;

/// Exponents of the variables of a ring, in their order.
using Exponents = std::vector<int>;

/// The polynomials in some variables over a tower.
class Ring : public std::enable_shared_from_this<Ring> {
 public:
  static RingPtr make(TowerPtr, std::vector<std::string> variables);
  ~Ring();
  Ring(const Ring&) = delete;
  Ring& operator=(const Ring&) = delete;

  const TowerPtr& tower() const;
  const std::vector<std::string>& variables() const;

  Polynomial constant(const Rational&) const;
  Polynomial variable(int index) const;
  /// A variable or a generator; nothing if there is no such symbol.
  std::optional<Polynomial> symbol(const std::string& name) const;
  /// coordinates / denominator. The coordinates may be those of a lower tower.
  Polynomial number(const Coordinates&, const Integer& denominator = 1) const;
  /// sum of coefficient * monomial; the coefficients are numbers over this tower or a lower
  /// one.
  Polynomial polynomial(const std::map<Exponents, Polynomial>&) const;
  /// The same polynomial as an element of this ring, which has all variables that occur, over
  /// this tower or a higher one.
  Polynomial embed(const Polynomial&) const;

  struct Body;  ///< FLINT's side of it
  const Body& body() const { return *body_; }

 private:
  Ring();
  std::unique_ptr<Body> body_;
};

/// An element of a ring, in normal form: powers of generators below their degree. So it is 0
/// exactly when it prints as 0. Immutable; copies share.
class Polynomial {
 public:
  struct Body;
  explicit Polynomial(std::shared_ptr<const Body> body) : body_(std::move(body)) {}

  const Ring& ring() const;
  bool is_zero() const;
  bool is_number() const;                               ///< no variables
  std::optional<Rational> rational() const;             ///< if it is one
  int degree(int variable) const;                       ///< -1 for 0
  int degree(const std::vector<int>& variables) const;  ///< total, in these

  /// Requires elements of one ring (or of two over one tower, in the same variables).
  friend Polynomial operator+(const Polynomial&, const Polynomial&);
  friend Polynomial operator-(const Polynomial&, const Polynomial&);
  friend Polynomial operator*(const Polynomial&, const Polynomial&);
  friend Polynomial operator*(const Rational&, const Polynomial&);
  Polynomial operator-() const;
  Polynomial pow(int exponent) const;
  friend bool operator==(const Polynomial&, const Polynomial&);

  Polynomial derivative(int variable) const;

  /// Each variable of this ring replaced by an element of `target`, whose tower is the same.
  Polynomial substitute(const RingPtr& target, const std::vector<Polynomial>& values) const;

  /// As a polynomial in some of the variables: the coefficients, elements of the same ring,
  /// that are not 0.
  std::map<Exponents, Polynomial> coefficients(const std::vector<int>& variables) const;

  /// The numbers in front of the monomials in all variables, times the positive number
  /// `denominator`.
  struct Numerators {
    std::map<Exponents, Coordinates> terms;
    Integer denominator = 1;
  };
  Numerators numerators() const;

  const Body& body() const { return *body_; }

 private:
  std::shared_ptr<const Body> body_;
};

}  // namespace seam::exact
