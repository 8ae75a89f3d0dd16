// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bernstein/form.h"
#include "prove/workshop.h"

namespace seam::prove {

/// A set of corners of a simplex.
using Corners = unsigned;

/// A simplex as certificate::Simplex describes it, in numbers.
struct Factor {
  std::vector<std::string> variables;
  std::vector<std::vector<exact::Polynomial>> corners;  ///< (weight, x...)
  std::vector<bool> open;
  Corners infinite = 0;  ///< the corners of weight 0
};
using Factors = std::vector<Factor>;

Factor make_factor(Workshop&, const certificate::Simplex&);
std::vector<std::string> variables(const Factors&);

/// `formula relation 0`.
struct Condition {
  exact::Polynomial formula;
  certificate::Relation relation;
};

/// A domain cut by conditions, with a further coordinate for each function of an obligation: a
/// factor each, after those given; what is known of the functions, after the conditions given,
/// not reduced; then whatever is supposed in a case. A logarithm has a factor too, which the
/// checker does not have: points of the region may refute, nothing is shown on it.
struct Region {
  Factors factors;
  std::vector<Condition> where;
  std::vector<const certificate::Function*> functions;
  std::size_t given = 0;  ///< conditions
  std::size_t known = 0;  ///< given, or of functions
  bool holds_log() const;
  bool is_elementary() const;  ///< one of the functions is no root
};
Region make_region(Workshop&, Factors given, const std::vector<certificate::Constraint>& where,
                   const std::vector<const certificate::Function*>&);
/// Of the variables and functions, in their order: those of the polynomials.
exact::RingPtr ring(const Workshop&, const Region&);

/// Whether a point of the simplex with exactly these barycentric coordinates positive is left
/// out: all at infinity, or on an open facet.
bool is_outside(const Factor&, Corners support);

/// A polynomial in the variables of the factors over their product: homogenised with the
/// weights, in barycentric coordinates. In a ring over the tower of the polynomial.
struct Barycentric {
  exact::Polynomial polynomial;
  std::shared_ptr<const bernstein::Shape> shape;
};
Barycentric in_barycentric(const Factors&, const exact::Polynomial&);

/// The point of a factor with these barycentric coordinates, not all at infinity: one value a
/// variable.
std::vector<exact::Polynomial> point(const Factor&, const std::vector<exact::Polynomial>& l);

}  // namespace seam::prove
