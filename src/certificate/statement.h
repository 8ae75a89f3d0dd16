// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include <string>
#include <variant>
#include <vector>

// What a claim says, as plain data: formulas as a straight-line program, and a
// combination of obligations about them. Computed from the claim alone.
namespace seam::certificate {

/// The index of a node in `Statement::nodes` (or, past its end, in `Evidence::nodes`).
using Term = int;

/// One step of a straight-line program; operands are earlier nodes.
struct Node {
  enum class Kind { constant, symbol, sum, product, power };
  Kind kind = Kind::constant;
  std::string text;            ///< constant: `-3/4`, in lowest terms; symbol: its name
  std::vector<Term> operands;  ///< sum, product: any number; power: the base alone
  int exponent = 0;            ///< power: >= 0

  bool operator==(const Node&) const = default;
};

/// `pi` is a number; the others are functions of one operand, `log` where it is positive.
enum class Elementary { none, exp, log, sin, cos, pi };

/// A real number: the one root, within [low, high], of a polynomial in
/// the symbol `name` whose coefficients are formulas in earlier generators.
/// `low` and `high` are rationals. Uniqueness is for the checker to verify.
/// With a `function`: its value at `argument`, a formula in earlier generators, instead.
struct Generator {
  std::string name;
  Term polynomial = 0;
  std::string low, high;
  Elementary function = Elementary::none;
  Term argument = 0;  ///< of a function other than pi

  bool operator==(const Generator&) const = default;
};

/// A root of a function. `name` is, at each point where the operand is >= 0, its root
/// >= 0 of this degree; elsewhere it has no value, and an obligation that holds it says
/// nothing. The operand is a formula in generators, variables and earlier functions.
/// With an `elementary` function (not pi): the value of that, instead; of log where the operand
/// is > 0.
struct Function {
  std::string name;
  Term operand = 0;
  int degree = 2;  ///< >= 2
  Elementary elementary = Elementary::none;

  bool is_root() const { return elementary == Elementary::none; }

  bool operator==(const Function&) const = default;
};

/// f > 0, f >= 0, f = 0, f != 0, f <= 0, f < 0.
enum class Relation { positive, nonnegative, zero, nonzero, nonpositive, negative };

/// A simplex in the space of `variables` (k of them): k + 1 corners, each in
/// homogeneous coordinates (weight, x1, ..., xk) with weight >= 0 (0: a point at
/// infinity), constant formulas. The set is
///     { (sum l_i x_i) / (sum l_i w_i) : l_i >= 0, sum l_i w_i > 0 },
/// less the facets l_i = 0 with `open[i]`. The corners must be independent.
/// A corner of weight 0 needs no mark: it is never a point of the set.
struct Simplex {
  std::vector<std::string> variables;
  std::vector<std::vector<Term>> corners;
  std::vector<bool> open;

  bool operator==(const Simplex&) const = default;
};

/// A condition `formula relation 0` that the points of a domain meet.
struct Constraint {
  Term formula = 0;
  Relation relation = Relation::nonnegative;

  bool operator==(const Constraint&) const = default;
};

/// A product of simplices, in variables all different, cut by constraints.
/// No factor: one point.
struct Domain {
  std::vector<Simplex> factors;
  std::vector<Constraint> where;

  bool operator==(const Domain&) const = default;
};

/// The formula is 0 identically, for all values of the variables it holds for which the
/// functions it holds have one.
struct Zero {
  Term formula = 0;

  bool operator==(const Zero&) const = default;
};

/// `formula relation 0` at every point of the domain at which all functions of the obligation
/// have a value. A variable of the formula or the constraints that belongs to no factor ranges
/// over all reals. With no variable: a statement about one real number.
struct Sign {
  Term formula = 0;
  Relation relation = Relation::positive;
  Domain domain;

  bool operator==(const Sign&) const = default;
};

/// A solution as it is claimed: an exact number, or "one, within [low, high]".
struct Solution {
  Term value = -1;        ///< -1: not given exactly
  std::string low, high;  ///< rationals, low < high; used when `value` is -1

  bool operator==(const Solution&) const = default;
};

/// Those x in the domain for which every formula of `system` vanishes for all real
/// values of the variables `for_all` are exactly `solutions`, all different.
/// `domain` is one simplex in the one variable `unknown`.
/// A domain with no corners means every real number (its one variable is still named).
struct Solutions {
  std::vector<Term> system;
  std::string unknown;
  std::vector<std::string> for_all;
  Simplex domain;
  std::vector<Solution> solutions;  ///< exact ones, or intervals that do not overlap, ascending

  bool operator==(const Solutions&) const = default;
};

/// At every point of (the domain) x (every real value of those unknowns that belong to no
/// factor of it) that meets the conditions of the domain and at which every formula of `system`
/// vanishes for all real values of the variables `for_all`, the unknowns x are one of
/// `solutions`: denominators[j] * x_j = numerators[j] for all j, for one of them. Those are
/// formulas in the variables of factors that are no unknowns, the parameters; the conditions
/// may hold unknowns.
struct OnlySolutions {
  struct Tuple {
    std::vector<Term> numerators, denominators;  ///< one an unknown
    bool operator==(const Tuple&) const = default;
  };
  std::vector<Term> system;
  std::vector<std::string> unknowns;
  std::vector<std::string> for_all;
  Domain domain;
  std::vector<Tuple> solutions;

  bool operator==(const OnlySolutions&) const = default;
};

/// Exactly one point of the domain meets its conditions and makes every formula of `system`
/// vanish for all real values of the variables `for_all`; there low[j] <= unknowns[j] <=
/// high[j]. The variables of the factors are the unknowns.
struct OneSolution {
  std::vector<Term> system;
  std::vector<std::string> unknowns;
  std::vector<std::string> for_all;
  Domain domain;
  std::vector<std::string> low, high;  ///< rationals

  bool operator==(const OneSolution&) const = default;
};

/// Patches glued along sides. Patch i is a disc whose corners are numbered from 0 to
/// its count less 1 and whose side s runs from corner `from` to corner `to`.
/// Says: every side lies on exactly one seam, the whole is connected, and
/// V - E + F = `euler`, V counting the corners after gluing.
struct Gluing {
  struct Side {
    int from = 0, to = 0;
    bool operator==(const Side&) const = default;
  };
  struct Seam {
    int patch = 0, side = 0, other_patch = 0, other_side = 0;
    bool reversed = false;  ///< the start of one side meets the end of the other
    bool operator==(const Seam&) const = default;
  };
  std::vector<std::vector<Side>> patches;
  std::vector<Seam> seams;
  int euler = 2;

  bool operator==(const Gluing&) const = default;
};

/// These tuples of numbers, all of one length, are pairwise different.
struct Distinct {
  std::vector<std::vector<Term>> tuples;

  bool operator==(const Distinct&) const = default;
};

/// A mesh, truncated as often as there are `ratios`, has the property. Vertices are numbered
/// from 0; a face is a list of vertices, all different, three at least, in the order of its
/// corners; what follows the last is the first. An edge is an unordered pair of vertices that
/// follow each other in a face.
///
/// Truncation at the ratio r, 0 < r < 1/2: each edge ab is cut at a + r (b - a) and
/// b + r (a - b). It is for an oriented manifold without a vertex that is on no face. New
/// vertex number i is the cut near the first end of side i; the sides are numbered face by
/// face, from each corner to the next. New face number f, below the number of faces, has the
/// cuts of the sides of face f, in order, each at both ends; then there follows for each
/// vertex, in order, the face of the cuts near it, turned so that the mesh is oriented again.
struct Mesh {
  enum class Property {
    counts,      ///< values: vertices, edges, faces
    face_sizes,  ///< values: size, how many faces of it, by rising size
    valences,    ///< values: valence, how many vertices of it (its edges), by rising valence
    valence,     ///< values: vertex, its valence
    connected,   ///< from each vertex to each other along edges
    closed,      ///< connected, and each edge is on exactly two faces
    manifold,    ///< each edge is on exactly two faces; the faces round each vertex form one
                 ///< cycle, and there are some
    orientable,  ///< no edge is on more than two faces, and the faces can be turned so that
                 ///< those of an edge pass it in opposite senses
    oriented,    ///< each edge is on exactly two faces, and these pass it in opposite senses
    planar,      ///< the corners of each face are in one plane; values: of these faces alone
    convex       ///< the boundary of a convex polyhedron with these vertices and these faces,
                 ///< all counterclockwise or all clockwise seen from outside
  };
  int vertices = 0;
  std::vector<std::vector<Term>>
      points;  ///< three coordinates a vertex, for planar and convex;
               ///< else none need be there, and none is looked at
  std::vector<std::vector<int>> faces;
  std::vector<Term> ratios;
  Property property = Property::counts;
  std::vector<int> values;

  bool operator==(const Mesh&) const = default;
};

using Obligation =
    std::variant<Zero, Sign, Solutions, OnlySolutions, OneSolution, Gluing, Distinct, Mesh>;

/// A combination of obligations. `all` of nothing holds; `any` of nothing fails. What
/// `suffices` holds where its part does, and is open where that fails.
struct Goal {
  enum class Kind { all, any, negation, suffices, obligation };
  Kind kind = Kind::all;
  std::vector<Goal> parts;  ///< all, any: any number; negation, suffices: one
  int obligation = -1;      ///< index in `Statement::obligations`

  bool operator==(const Goal&) const = default;
};

/// What one claim says. It holds when every guard holds and the goal is true; it
/// fails when every guard holds and the goal is false. Guards say that the formulas
/// mean something: divisors that do not vanish, radicands that are not negative,
/// numbers that are the root they are named for.
struct Statement {
  std::vector<Generator> generators;  ///< each in terms of those before it
  std::vector<Function> functions;    ///< likewise
  std::vector<Node> nodes;
  std::vector<Obligation> obligations;
  std::vector<int> guards;  ///< indices in `obligations`
  Goal goal;

  bool operator==(const Statement&) const = default;
};

}  // namespace seam::certificate
