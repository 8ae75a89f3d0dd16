// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "exact/rational.h"

namespace seam::exact {

class Tower;
using TowerPtr = std::shared_ptr<const Tower>;  ///< null: the rationals

/// The coordinates of a number in the basis of its tower; integers unless said otherwise.
using Coordinates = std::vector<Integer>;

/// A real number field: the field `below` with one more real root adjoined.
///
/// The root goes by the name of a `symbol`, and internally by h = scale * symbol, which is
/// integral: its defining polynomial is monic with coefficients that have integer coordinates.
/// The basis is h^e * (basis of the field below), e = 0, 1, ..., degree - 1, with e the slower
/// index.
///
/// That the defining polynomial is irreducible is the caller's promise (`factor.h`
/// makes it so); it makes a number zero exactly when its coordinates are.
class Tower {
 public:
  /// The root of h^degree = sum tail[j] h^j that lies strictly between scale * low and scale *
  /// high. The polynomial has opposite signs there and this root only.
  Tower(TowerPtr below, std::string symbol, Integer scale, std::vector<Coordinates> tail,
        Rational low, Rational high);
  ~Tower();
  Tower(const Tower&) = delete;
  Tower& operator=(const Tower&) = delete;

  const TowerPtr& below() const { return below_; }
  const std::string& symbol() const { return symbol_; }
  const Integer& scale() const { return scale_; }
  int degree() const { return static_cast<int>(tail_.size()); }
  const std::vector<Coordinates>& tail() const { return tail_; }

  struct Enclosures;  ///< balls around the basis, at some precision

 private:
  friend const Enclosures& enclosures(const TowerPtr&, long);
  const TowerPtr below_;
  const std::string symbol_;
  const Integer scale_;
  const std::vector<Coordinates> tail_;
  const Rational low_, high_;
  mutable std::unique_ptr<Enclosures> enclosures_;
};

int dimension(const TowerPtr&);                    ///< over the rationals
int height(const TowerPtr&);                       ///< how many generators
std::vector<const Tower*> steps(const TowerPtr&);  ///< the lowest first

/// Sign of a number: by enclosures at growing precision, zero by its coordinates.
Sign sign(const TowerPtr&, const Coordinates&);

/// [low, high] around the number; high - low <= 2^-bits * max(1, |number|).
struct Enclosure {
  Rational low, high;
};
Enclosure enclosure(const TowerPtr&, const Coordinates&, long bits);

/// Nearly the number, with a bound on the error.
struct Ball {
  double middle = 0, radius = 0;
};
Ball ball(const TowerPtr&, const Coordinates&);

}  // namespace seam::exact
