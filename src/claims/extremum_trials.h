// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "claims/evaluate.h"

// Search only: points of the domains of an extremum, for functions of any kind.
namespace seam::claims {

/// A point of a part of an extremum: of each factor of its domain, the weights of the corners.
struct Trial {
  std::size_t part = 0;
  std::vector<std::vector<int>> weights;
  double value = 0;        ///< about, of the part; not a number where it has none
  bool is_centre = false;  ///< a corner, or the centre of a face
};

/// The corners and centres of all faces.
std::vector<Trial> centres(Evaluator&, const Extremum&);
/// These, and the points of a grid.
std::vector<Trial> trials(Evaluator&, const Extremum&);

/// Its coordinates.
std::map<std::string, Formula> point_of(const Extremum&, const Trial&);

/// Whether a symbol that is none of its domain's occurs in its value.
bool has_parameter(const Extremum::Part&);
/// Whether a part holds a root of a function.
bool has_roots(const Extremum&);

/// About the value of a function where its variables have these values.
double approximate(const Scalar&, const std::map<std::string, double>& point, const Numbers&);

}  // namespace seam::claims
