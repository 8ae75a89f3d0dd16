// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "prove/samples.h"

namespace seam::prove {

/// Signs on a region with functions or equations, by reduction to others until subdivision
/// shows them; and points at which they fail.
class Derivation {
 public:
  Derivation(Workshop&, Region);

  /// `f relation 0` on the region. Nothing if no proof was found.
  std::optional<certificate::SignProof> show(const exact::Polynomial& f, certificate::Relation);
  /// The same by multiples of conditions alone, found by linear programming.
  std::optional<certificate::SignProof> combine(const exact::Polynomial& f,
                                                certificate::Relation);
  /// A point of the region at which `f relation 0` fails, if one is found.
  std::optional<certificate::Point> refute(const exact::Polynomial& f, certificate::Relation);

 private:
  static constexpr int most_depth = 8;
  using Shown = std::optional<certificate::SignProof>;
  /// What is to be shown: with `side` 1 or -1 that f * side is positive, or not negative; with
  /// 0 that f is 0.
  struct Goal {
    certificate::Relation relation;
    int side;
    bool strict() const;
  };
  static Goal upward(bool strict);
  static Goal weak(int side);
  /// f = constant + factor * root, the root of degree 2 the last function in f.
  struct Linear {
    exact::Polynomial constant, factor, root;
    exact::Polynomial norm;  ///< constant^2 - factor^2 * radicand
  };
  /// A condition of the region that says of a polynomial that it has a sign: it is
  /// `scale` times the formula of the condition.
  struct Known {
    int condition, scale;
  };
  /// cofactor * condition
  struct Multiple {
    int condition;
    exact::Polynomial cofactor;
  };

  Shown show(exact::Polynomial f, Goal, int depth);
  Shown show_zero(const exact::Polynomial& f, int depth);
  Shown subdivide(const exact::Polynomial& f, Goal, bool is_free, long effort);
  Shown by_equations(const exact::Polynomial& f, Goal, int depth);
  Shown by_inequalities(const exact::Polynomial& f, Goal);
  Shown by_factor(const exact::Polynomial& f, Goal, int depth);
  Shown by_multiplier(const Linear&, Goal, int depth);
  Shown by_conjugate(const Linear&, Goal, int depth);
  Shown by_conditions(const Linear&, Goal, int depth);
  Shown by_cases(const exact::Polynomial& f, const Linear&, Goal, int depth);
  Shown sum(const Linear&, bool of_constant, Goal, int depth);
  Shown in_case(const exact::Polynomial& a, certificate::Relation, const exact::Polynomial& f,
                Goal, int depth);
  Shown combination(const std::vector<Multiple>&, Shown rest);

  exact::Polynomial now(const exact::Polynomial&) const;
  bool holds_function(const exact::Polynomial&) const;
  std::optional<Linear> linear(const exact::Polynomial&);
  std::optional<Known> known(const exact::Polynomial&, int side) const;
  bool is_plausible(const exact::Polynomial&, Goal) const;

  Workshop& workshop_;
  Region region_;
  std::vector<Sample> samples_;
  std::vector<Place> places_;  ///< where something that would be enough fails
};

}  // namespace seam::prove
