// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "report/run.h"

namespace seam::report {

/// Obligations that are alike but for their formulas: one entry in a report.
struct ObligationGroup {
  const ObligationRun* first;
  int count = 0;
  std::vector<std::string> evidence;  ///< the different ones
};

/// In the order of their first members.
std::vector<ObligationGroup> grouped(const std::vector<ObligationRun>&);

/// `holds`, `fails`, `open`.
const char* name(ObligationRun::Status);

/// What an obligation is about: in its own words, or by its kind.
std::string about(const ObligationRun&);

}  // namespace seam::report
