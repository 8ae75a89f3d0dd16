// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "report/run.h"

namespace seam::report {

/// What the verdicts of a file rest on; all that is pointed to is part of the file.
struct Assumptions {
  struct Parameter {
    const DefinitionRun* definition;
    int claims;  ///< that hold for all that it may be; more than 0
  };
  /// A condition under which the formulas of a claim mean something.
  struct Guard {
    const ClaimRun* claim;
    const ObligationRun* guard;
  };
  struct Used {
    std::string id;
    const ClaimRun* claim;  ///< null: not among those that were looked at
  };
  struct Use {
    const ClaimRun* claim;
    std::vector<Used> rests_on;
  };
  std::vector<Parameter> parameters;
  int guards_proven = 0;
  std::vector<Guard> guards_not_proven;  ///< what rests on them is not decided
  std::vector<Use> uses;

  bool empty() const;
};

inline constexpr const char* assumptions_title = "What the verdicts rest on";

/// Everything in file order.
Assumptions assumptions(const FileRun&);

}  // namespace seam::report
