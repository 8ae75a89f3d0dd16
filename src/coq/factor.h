// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "coq/formula.h"

namespace seam::coq {

/// What a point of a simplex meets: `text`, or that `gap` is > 0 or >= 0, which is the same.
struct Inequality {
  std::string name, text;
  Written gap;
  bool is_strict = false;
};

/// How a simplex is written: as inequalities where these are the readable form, or as its
/// points are, by barycentric coordinates whose weighted sum is 1.
struct Factor {
  enum class Shape { segment, ray_up, ray_down, triangle, general };
  Shape shape = Shape::general;
  const certificate::Simplex* simplex = nullptr;
  std::vector<std::string> variables;    ///< named
  std::vector<std::string> coordinates;  ///< barycentric, one a corner, named
  std::string sum;                       ///< named: that their weighted sum is 1
  std::vector<std::string> equations;    ///< named: what each variable is, by coordinates
  std::vector<std::string> signs;        ///< named: coordinate >= 0
  std::vector<std::string> strict;       ///< named: coordinate > 0 where its facet is open
};

Factor read_factor(const certificate::Simplex&, const Formulas&, Names&);

/// Of a factor that is written by inequalities, when the variables have their places.
std::vector<Inequality> inequalities(const Factor&, const Formulas&, Names&);

/// The weighted sum of the coordinates, and each variable by them; when these have places.
Written weighted_sum(const Factor&, const Formulas&);
Written variable_by_coordinates(const Factor&, std::size_t variable, const Formulas&);

}  // namespace seam::coq
