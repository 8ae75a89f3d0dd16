// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include <cstdint>
#include <set>
#include <vector>

#include "check/context.h"

namespace seam::check {

/// Some of the corners of a simplex, a bit each.
using Corners = std::uint32_t;
using Coordinates = std::vector<Polynomial>;

/// A simplex as `certificate::Simplex` describes it, in numbers. Corners are independent, their
/// weights not negative.
struct Factor {
  std::vector<int> variables;
  std::vector<Coordinates> corners;
  std::vector<bool> open;
  Corners finite = 0;   ///< the corners of positive weight
  int orientation = 1;  ///< the sign of the determinant of the corners
  int first = 0;        ///< the symbol of barycentric coordinate 0; the others follow
};

struct Condition {
  Polynomial formula;
  certificate::Relation relation;
};

/// Points of the product of the factors, and of the real line for each of the `lines`, at which
/// the conditions hold.
struct Region {
  std::vector<Factor> factors;
  std::vector<Condition> where;
  std::set<int> lines = {};
};

/// Throws `Open` unless the corners are independent, of weights >= 0, and few.
Factor make_factor(Context&, std::vector<int> variables, std::vector<Coordinates> corners,
                   std::vector<bool> open, int first_symbol);
/// Throws `Open` if this is no domain: see `certificate::Domain`. Conditions may hold these
/// symbols beside variables of factors.
Region make_region(Context&, const certificate::Domain&, const std::set<int>& others = {});
/// The region with these functions as further coordinates, each in a factor: a root in
/// [0, infinity), with the condition function^degree - operand = 0; exp in (0, infinity); sin
/// and cos in [-1, 1], with sin^2 + cos^2 - 1 = 0 for a sine that has its cosine. Conditions
/// stand as they are: not reduced. A log has no coordinate.
Region with_functions(Context&, Region, const std::set<int>& functions);
std::set<int> variables(const Region&);
/// The factors of the region, cut by those conditions that hold no line: what it lies over.
Region without_lines(Context&, const Region&);

/// Whether (1, values) lies in the simplex, open facets left out.
bool contains(Context&, const Factor&, const Coordinates& values);

/// The formula in barycentric coordinates, homogeneous in those of each factor: at a point of
/// the region a positive multiple of the formula.
Polynomial in_barycentric(Context&, const Region&, Polynomial formula);

/// By minors, without division. Requires a square matrix.
Polynomial determinant(Ring&, const std::vector<Coordinates>& rows);

}  // namespace seam::check
