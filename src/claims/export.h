// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "certificate/statement.h"
#include "claims/state.h"

namespace seam::claims {

/// A statement as plain data, and for each of its obligations what it is about and what it
/// says, for people.
struct Exported {
  /// By how much an obligation that is a sign holds: the formula / `scale`, in units of `unit`.
  struct Measure {
    certificate::Term scale = -1;  ///< -1: 1
    std::string unit;              ///< empty: the formula itself
  };
  certificate::Statement statement;
  std::vector<std::string> about;
  std::vector<std::string> text;
  std::vector<Measure> measures;
  std::vector<certificate::Node>
      further;  ///< nodes of scales, numbered on from the statement's
};

/// Formulas become nodes of a straight-line program as they are, shared parts once; facts of
/// known values and the guards of `stated` become guards. Equal input gives equal output.
Exported exported(const Stated& stated, const Numbers&);

}  // namespace seam::claims
