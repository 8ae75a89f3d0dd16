// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <vector>

#include "prove/workshop.h"

namespace seam::prove {

/// The ideal of some polynomials, as far as it can be seen by solving one after the other for a
/// variable in which it is linear with a number in front, and by dividing by leading monomials.
class LinearIdeal {
 public:
  /// f = rest + sum cofactors[i] * (generator i).
  struct Division {
    exact::Polynomial rest;
    std::map<std::size_t, exact::Polynomial> cofactors;
  };

  explicit LinearIdeal(Workshop& workshop) : workshop_(workshop) {}

  /// The next generator. All are elements of rings in the same variables.
  void add(const exact::Polynomial&);
  Division divide(const exact::Polynomial& f) const;
  /// Those that could not be solved, divided by the others.
  const std::vector<Division>& unsolved() const { return unsolved_; }

 private:
  struct Solved {
    int variable;         ///< -1: a number
    Division expression;  ///< of what is divided by: variable + terms without it, or 1
  };
  bool take_off_a_multiple(Division&) const;
  void divide_by(const Solved&, Division&) const;

  Workshop& workshop_;
  std::vector<Solved> solved_;
  std::vector<Division> unsolved_;
  std::size_t count_ = 0;
};

}  // namespace seam::prove
