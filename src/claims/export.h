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
  certificate::Statement statement;
  std::vector<std::string> about;
  std::vector<std::string> text;
};

/// Formulas become nodes of a straight-line program as they are, shared parts once; facts of
/// known values and the guards of `stated` become guards. Equal input gives equal output.
Exported exported(const Stated& stated, const Numbers&);

}  // namespace seam::claims
