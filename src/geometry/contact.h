// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "geometry/identity.h"
#include "geometry/side_contact.h"
#include "geometry/similarity.h"
#include "geometry/surface.h"
#include "symbolic/proposition.h"

// Predicates on patches and surfaces in space as propositions about formulas. Each says exactly
// what the table "Predicates" of docs/language.md says; nothing is decided here. Search chooses
// what is stated (which sides, which tuples), and what is stated is enough for what is meant.
// The conditions on two patches along a side are in side_contact.h.
namespace seam::geometry {

using symbolic::Proposition;

/// The normal vanishes nowhere on the closed domain.
Proposition regular(const Patch&);

/// A proposition that is enough for a predicate on patches whose control points may hold
/// variables: if it holds, the predicate holds for all their values.
struct Criterion {
  enum class Failure {
    refutes,                ///< the predicate does not hold for all values
    refutes_by_identities,  ///< so if an identity fails; of an inequality it says nothing
    says_nothing
  };
  Proposition proposition;
  Failure failure = Failure::refutes;
  /// What is asked of all of these patches taken together, not of each: that these formulas are
  /// not all identically 0. None: nothing.
  std::vector<Formula> nonzero = {};
};

/// What it takes to choose what is stated.
struct Search {
  const Numbers& numbers;
  Vanishing vanishes;
  std::vector<std::map<std::string, Formula>> samples;  ///< values that the variables may have
};

/// One full side of p is one full side of q (which one, and in which direction, is searched;
/// the equality is stated), and there the condition holds. No such pair: a proposition that
/// fails, with a witness for each pair of sides.
Criterion along_a_common_side(const Patch& p, const Patch& q, const Condition&, const Search&);

/// x ends where y begins, and there is a reparametrisation, with a derivative > 0, with which
/// their derivatives to this order are equal; and: they are so as they are. Of one dimension.
Proposition equal_jets(const Curve& x, const Curve& y, int order);
Proposition equal_derivatives(const Curve& x, const Curve& y, int order);

/// Every seam; and at every interior corner the patches wind round the normal exactly once.
/// Several patches that do not hang together through seams fail: smoothness is never claimed
/// for want of seams.
Proposition g1(const Surface&, const Numbers&);
Proposition g2(const Surface&, const Numbers&);

/// Every side on exactly one seam (equal curves: stated; distinct seams: stated), connected,
/// Euler characteristic.
Proposition closed(const Surface&, const Numbers&);
int euler_characteristic(const Surface&);

/// closed, G1, Gauss curvature > 0 everywhere, and Euler characteristic 2.
Proposition convex(const Surface&, const Numbers&);

/// Every point is a corner of a patch, or the image of an exact parameter.
Proposition interpolates(const Surface&, const std::vector<Point>&, const Numbers&);

/// All in one plane; of any dimension.
Proposition planar(const std::vector<Point>&);

}  // namespace seam::geometry
