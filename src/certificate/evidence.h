// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "certificate/statement.h"

// Why an obligation holds or fails, as plain data. Nothing here is believed: the
// checker recomputes whatever an entry says.
namespace seam::certificate {

/// Nothing known: the obligation stays undecided.
struct Nothing {
  std::string reason;  ///< one word: time memory effort unsupported degenerate assumption
  std::string detail;  ///< a sentence

  bool operator==(const Nothing&) const = default;
};

/// "Compute and see": for Zero the normal form, for Sign over no factor the enclosure
/// (and the normal form where that is 0), for Gluing and Distinct the count. Holds or fails.
struct Computation {
  bool operator==(const Computation&) const = default;
};

/// How a product of simplices was cut until every piece was plain, depth first.
struct Step {
  enum class Kind {
    plain,    ///< the coefficients over this piece show the sign
    outside,  ///< constraint number `index` is broken all over this piece
    split     ///< factor number `index` is split at `weights`; the parts follow
  };
  Kind kind = Kind::plain;
  int index = 0;
  /// split: barycentric, one a corner of the piece, none negative, not all 0. For each i
  /// with weights[i] > 0 there follows, by rising i, the part in which the point
  /// (sum weights_j corner_j) takes the place of corner i.
  std::vector<Term> weights;

  bool operator==(const Step&) const = default;
};
using Subdivision = std::vector<Step>;

/// A Sign obligation by subdivision. For `nonzero`, `side` says which sign the formula has
/// throughout (positive or negative).
///
/// With `square` >= 0 the formula is square^2 * cofactor (an identity that the checker
/// verifies), the relation is nonnegative or nonpositive, and the steps are about the cofactor.
struct Pieces {
  Subdivision steps;
  Relation side = Relation::positive;
  Term square = -1, cofactor = -1;

  bool operator==(const Pieces&) const = default;
};

/// A sign on a region that follows from other signs there. A region is a domain with, for each
/// function of the obligation (and of the radicands of these), one coordinate more: a factor
/// [0, infinity) after those given, and after the conditions given name^degree - radicand = 0.
///
///   multiplier    h = terms[0]; parts: h > 0 (not looked at if R is !=); h * f R 0.
///   conjugate     h = terms[0]; for R one of > >= (and likewise with < <=: f and h change
///                 sign). parts: f + h >= 0; f * h R 0.
///   cases         a = terms[0]; parts: f R 0 with the condition a >= 0 added to those of the
///                 region, and with a < 0 added.
///   combination   parts: f - (sum terms[i] * e_i) R 0, e_i the formula of condition
///                 conditions[i]; then for each i, unless that condition is e_i = 0, that
///                 terms[i] has the sign, or is 0, that makes terms[i] * e_i help the relation.
struct Reduction {
  enum class Kind { multiplier, conjugate, cases, combination };
  Kind kind = Kind::multiplier;
  std::vector<Term> terms;
  std::vector<int> conditions;  ///< combination: indices in the conditions of the region
  std::vector<std::variant<Computation, Pieces, Reduction>> parts;

  bool operator==(const Reduction&) const = default;
};

/// Why `f R 0` on a region. By computation: f is a number, in normal form.
using SignProof = std::variant<Computation, Pieces, Reduction>;

/// One value for each variable, and for each function that stands in the obligation.
struct Point {
  std::vector<std::string> variables;
  std::vector<Term> values;

  bool operator==(const Point&) const = default;
};

/// Refutes Zero (the formula is not 0 there; any point, no domain) or Sign (the point lies in
/// the domain and the relation fails there). With `other`: refutes `nonzero` by a
/// change of sign between two points of the same (convex, unconstrained) domain, if no
/// function stands in the obligation.
struct Witness {
  Point point;
  std::vector<Point> other;  ///< none or one

  bool operator==(const Witness&) const = default;
};

/// Solutions, one unknown x. Let F1, F2, ... be the coefficients of the system with respect to
/// the variables `for_all`: for each formula in order, its nonzero coefficients, by
/// rising exponent vectors in lexicographic order, the first variable of `for_all` first.
///
///   divisor = sum cofactors[i] * F_i      and      F_i = quotients[i] * divisor,
///
/// so the common roots are those of `divisor`. Exact solutions s_j:
///   divisor = rest * product (x - s_j)^multiplicities[j], and `rest` is != 0 on the domain
///   (`outside`, one tree); every s_j lies in the domain, all are different.
/// Intervals: `divisor` changes sign over each [low, high] and its derivative is != 0 there
/// (`inside`, one tree each), every [low, high] lies in the domain, and divisor != 0 on the
/// parts of the domain between and beside them (`outside`, one tree each, ascending). A part
/// that is a single point takes an entry of `outside` too, which nobody reads. The corners of a
/// part are in ascending order: those of the domain as they are given there, ends of intervals
/// as (1, end). Over a domain with no corners (every real number): exact solutions, or none,
/// take two trees in `outside`, over [0, infinity) with the corners (1, 0), (0, 1) and over
/// (-infinity, 0] with the corners (0, -1), (1, 0); intervals take the outermost parts with the
/// corners (0, -1), (1, low) and (1, high), (0, 1). A divisor that is a nonzero constant (rest
/// = divisor) has no roots.
struct Roots {
  Term divisor = 0;
  std::vector<Term> cofactors, quotients;
  std::vector<int> multiplicities;
  Term rest = 0;
  std::vector<Pieces> inside, outside;

  bool operator==(const Roots&) const = default;
};

/// Refutes Solutions by a number x that lies in the domain: claimed but not a solution
/// (some F_i is not 0 there), or a solution that is different from all that are claimed (or
/// from all intervals).
struct WrongSolution {
  Term value = 0;
  int claimed = -1;  ///< the index of the one that is none, or -1: `value` is missing
  bool operator==(const WrongSolution&) const = default;
};

using Proof =
    std::variant<Nothing, Computation, Pieces, Reduction, Witness, Roots, WrongSolution>;

/// One proof an obligation, in order. Its own numbers and formulas extend those of the
/// statement: nodes are numbered on from `Statement::nodes`.
struct Evidence {
  std::vector<Generator> generators;
  std::vector<Node> nodes;
  std::vector<Proof> proofs;

  bool operator==(const Evidence&) const = default;
};

enum class Verdict { proven, refuted, conditional, undecided };

/// What is written to disk for one claim (or for its correction).
struct Certificate {
  std::string claim;                     ///< its id
  bool correction = false;               ///< of the printed statement, or of `corrected:`
  Verdict verdict = Verdict::undecided;  ///< as the prover has it
  std::vector<std::string> using_claims;
  Statement statement;
  Evidence evidence;

  bool operator==(const Certificate&) const = default;
};

}  // namespace seam::certificate
