// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>

#include "certificate/evidence.h"
#include "symbolic/formula.h"

namespace seam::cli {

/// The formulas of a statement and its evidence, to be printed: shared nodes are built once.
class Formulas {
 public:
  Formulas(const certificate::Statement& statement, const certificate::Evidence& evidence)
      : statement_(statement), evidence_(evidence) {}

  symbolic::Formula operator()(certificate::Term);

 private:
  const certificate::Statement& statement_;
  const certificate::Evidence& evidence_;
  std::map<certificate::Term, symbolic::Formula> done_;
};

/// As a reader writes it: `u~` and `v~`, the parameters of a patch, are u and v; `x'{t}`, the
/// value of an arbitrary function, is x'(t).
std::string readable(std::string text);

/// `u = 1/2, x = (1, 2, 3)`: the coordinates of a vector stand together, once all are there.
std::string point_text(const certificate::Point&, Formulas&);

}  // namespace seam::cli
