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
/// (and the normal form where that is 0), for Gluing, Distinct and Mesh the count. Holds or
/// fails.
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
///   both          for R =; no terms. parts: f >= 0; f <= 0.
///   cases         a = terms[0]; parts: f R 0 with the condition a >= 0 added to those of the
///                 region, and with a < 0 added.
///   condition     f = terms[0] * (the formula of condition conditions[0]), terms[0] a number;
///                 where that condition holds, so does f R 0. No parts.
///   factors       f, or -f if R is one of < <=, is the product of the terms; parts: for each,
///                 that it is > 0, >= 0 or != 0, as R is strict, weak, or !=.
///   squares       terms: w_1 ... w_n, q_1 ... q_n, and, as R strict or != needs, m_1 ... m_n.
///                 f = sum w_i q_i^2, the w_i numbers != 0 all of the sign that R wants (for
///                 !=: of one). If there are m_i: parts: (the product of the formulas of the
///                 conditions) - sum m_i q_i = 0; each of these conditions excludes 0.
///   combination   parts: f - (sum terms[i] * e_i) R 0, e_i the formula of condition
///                 conditions[i]; then for each i, unless that condition is e_i = 0, that
///                 terms[i] has the sign, or is 0, that makes terms[i] * e_i help the relation.
struct Reduction {
  enum class Kind {
    multiplier,
    conjugate,
    both,
    cases,
    condition,
    factors,
    squares,
    combination
  };
  Kind kind = Kind::multiplier;
  std::vector<Term> terms;
  std::vector<int> conditions;  ///< indices in the conditions of the region
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

/// Refutes Zero (the formula is not 0 there; any point, no domain), Sign (the point lies in
/// the domain and the relation fails there) or OnlySolutions (it lies in the domain, solves the
/// system, and is none of the solutions). With `other`: refutes `nonzero` by a
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

/// A sum of equations that are known, each times a cofactor: 0 wherever they hold.
struct Combination {
  std::vector<int> equations;  ///< by the order in which they became known
  std::vector<Term> cofactors;
  bool operator==(const Combination&) const = default;
};

/// A factor formula^power of something that vanishes. That it does not vanish itself is either
/// a condition, or shown by trees (see Elimination); with neither it is a case.
struct EliminationFactor {
  Term formula = 0;
  int power = 1;
  int condition = -1;
  std::vector<SignProof> trees;
  bool operator==(const EliminationFactor&) const = default;
};

/// One step of an elimination, at a point that is supposed to solve the system.
struct EliminationStep {
  enum class Kind {
    product,   ///< `combination` is the product of `factors`: one of the cases vanishes
    cases,     ///< `formula` vanishes, or it does not
    solution,  ///< the known `equations` say, unknown by unknown, that this is solution `index`
    outside    ///< condition `index` is broken
  };
  Kind kind = Kind::product;
  Combination combination;                  ///< product, outside
  std::vector<EliminationFactor> factors;   ///< product
  Term formula = 0;                         ///< cases; outside: the multiplier
  Term remainder = 0;                       ///< outside
  int index = 0;                            ///< solution, outside
  std::vector<int> equations;               ///< solution
  std::vector<SignProof> positive, broken;  ///< outside
  bool operator==(const EliminationStep&) const = default;
};

/// OnlySolutions: a tree of cases, depth first. What is known at first are the equations
/// F_i = 0, F_i the coefficients of the system in the order laid down for Roots, and the
/// conditions of the domain.
///
///   product   for each case, in order, there follows what comes of the equation
///             `formula` = 0, known from there on. Without a case there is no such point.
///   cases     there follows what comes of the equation `formula` = 0, then what comes of the
///             condition `formula` != 0; each is the last one known there.
///   solution  equation `equations[j]` is denominators[j] * x_j - numerators[j].
///   outside   formula * (that of the condition) = combination + remainder; the trees
///             `positive` show formula > 0, the trees `broken` that the remainder breaks the
///             condition.
///
/// Trees are about a region (see Reduction), for all functions of the obligation: the domain,
/// and the conditions known there. Of the unknowns that belong to no factor those that the
/// formula holds, in their order x_1, ..., x_k, are taken from both sides of 0: there are 2^k
/// trees, the first with all x <= 0, the next with x_1 >= 0, then x_2 >= 0 alone, and so on,
/// over the factors of the domain and one for each x, with the corners (1, 0), (0, -1) or (1,
/// 0), (0, 1). Conditions that hold other variables are left out there, and the others are
/// counted without them.
struct Elimination {
  std::vector<EliminationStep> steps;
  bool operator==(const Elimination&) const = default;
};

/// A box: low[j] <= x_j <= high[j], rationals.
struct Box {
  std::vector<std::string> low, high;
  bool operator==(const Box&) const = default;
};

/// OneSolution, in n unknowns, by a zero of n polynomials G_i = sum combination[i][j] * F_j,
/// the F_j as in Roots; there are n of them, and the determinant of the combination is not 0.
///
///   inner      A solution lies in this box, which lies in the domain: G_i < 0 where x_i is
///              lowest there, G_i > 0 where it is highest (`faces`: two trees for each i, over
///              the segments of the other unknowns in their order); and each condition holds
///              all over it (`conditions`, one tree each).
///   outer      This box, which holds the inner one, has one at most: for each i, and each
///              choice of signs, the derivative of G_i with respect to x_i plus those with
///              respect to the others, times the signs, is > 0 there (`dominance`: for each i,
///              2^(n-1) trees; bit k of the number of a tree set: the sign at the k-th of the
///              others, in their order, is -).
///   cover      All solutions lie in the outer box: two trees for each j, for x_j - low_j >= 0
///              and high_j - x_j >= 0 over the domain, cut by its conditions, then by
///              F_1 = 0, ..., F_n = 0, then by G_1 = 0, ..., G_n = 0.
///
/// With the inner box in that of the statement this shows it. With an inner box apart from
/// that, it refutes, and only inner box, faces and conditions are looked at. With no boxes and
/// no combination, and `cover` one tree for -1 >= 0 there (without the G), there is no
/// solution: it refutes.
struct Isolation {
  std::vector<std::vector<std::string>> combination;  ///< rationals
  Box inner, outer;
  std::vector<Pieces> faces, conditions, dominance, cover;
  bool operator==(const Isolation&) const = default;
};

using Proof = std::variant<Nothing, Computation, Pieces, Reduction, Witness, Roots,
                           WrongSolution, Elimination, Isolation>;

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
