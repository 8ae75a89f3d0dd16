// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "certificate/statement.h"
#include "symbolic/formula.h"

// Statements about formulas: what claims and predicates are turned into before they
// become obligations. Each type mirrors one of certificate/statement.h.
namespace seam::symbolic {

using certificate::Gluing;
using certificate::Relation;

/// See certificate::Simplex. Coordinates are constant formulas, the weight first.
struct Simplex {
  std::vector<std::string> variables;
  std::vector<Point> corners;
  std::vector<bool> open;
};

/// [low, high], ends excluded where `open`.
Simplex interval(const std::string& variable, const Formula& low, const Formula& high,
                 bool open_low = false, bool open_high = false);
Simplex whole_line_right(const std::string& variable, const Formula& from,
                         bool open);  ///< from .. infinity
Simplex whole_line_left(const std::string& variable, const Formula& to,
                        bool open);  ///< -infinity .. to
/// u, v >= 0, u + v <= 1 (and likewise for more variables); `interior`: without the boundary.
Simplex standard_simplex(const std::vector<std::string>& variables, bool interior = false);

/// `scale`: what the difference of the sides of a comparison was multiplied by, which is > 0
/// where it is spoken of; none: the formula does not come of one.
struct Constraint {
  Formula formula;
  Relation relation;
  std::optional<Formula> scale = {};
};

struct Domain {
  std::vector<Simplex> factors;
  std::vector<Constraint> where;
};

/// What one is of a formula, for people: `formula = scale * (what is measured, in units of
/// `unit`)`, with scale > 0 on the domain.
struct Measure {
  Formula scale = 1;
  std::string unit;  ///< empty: nothing but the formula itself
};

/// Identically zero in all its variables.
struct Zero {
  Formula formula;
};
/// formula relation 0 on the domain and, for variables that belong to no factor, for all reals.
struct Sign {
  Formula formula;
  Relation relation;
  Domain domain;
  Measure measure = {};
};
struct Solutions {
  std::vector<Formula> system;
  std::string unknown;
  std::vector<std::string> for_all;
  Simplex domain;
  std::vector<Formula> exact;                                     ///< either these
  std::vector<std::pair<exact::Rational, exact::Rational>> near;  ///< or these
};
struct OnlySolutions {
  std::vector<Formula> system;
  std::vector<std::string> unknowns, for_all;
  Domain domain;
  /// By solution and unknown: numerator and denominator.
  std::vector<std::vector<std::pair<Formula, Formula>>> solutions;
};
struct OneSolution {
  std::vector<Formula> system;
  std::vector<std::string> unknowns, for_all;
  Domain domain;
  std::vector<std::pair<exact::Rational, exact::Rational>> near;  ///< one an unknown
};
struct Distinct {
  std::vector<Point> tuples;
};
struct Mesh {
  using Property = certificate::Mesh::Property;
  int vertices = 0;
  std::vector<Point> points;  ///< none where the property is one of faces and edges alone
  std::vector<std::vector<int>> faces;
  std::vector<Formula> ratios;
  Property property = Property::counts;
  std::vector<int> values;
};

using Atom =
    std::variant<Zero, Sign, Solutions, OnlySolutions, OneSolution, Gluing, Distinct, Mesh>;

/// A combination of such statements, with a few words on what each part is about (for the
/// report: "equal tangent planes along the seam").
struct Proposition {
  enum class Kind { all, any, negation, suffices, atom };
  Kind kind = Kind::all;
  std::string about;
  std::vector<Proposition> parts;
  Atom atom;
};

Proposition all(std::vector<Proposition> parts, std::string about = {});
Proposition any(std::vector<Proposition> parts, std::string about = {});
Proposition negation(Proposition part, std::string about = {});
/// Holds where the part holds; its failure says nothing.
Proposition suffices(Proposition part, std::string about = {});
Proposition atom(Atom statement, std::string about = {});

Proposition truth();      ///< all of nothing
Proposition falsehood();  ///< any of nothing

}  // namespace seam::symbolic
