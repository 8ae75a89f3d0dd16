// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "report/run.h"

namespace seam::report {

/// The verdicts of a section: where in the paper the trouble is.
struct Tally {
  std::string title;  ///< `before the first section`, where there is none
  int section = 0;    ///< the number of the section in the file, from 1 on; 0 before the first
  Summary summary;
};

/// The sections that hold claims, in file order.
std::vector<Tally> by_section(const FileRun&);

/// `Of 61 claims, 55 proven, …; 61 are as the author of the file expects.`
std::string sentence(const Summary&);

/// Whether the checker objected to any evidence.
bool has_alarm(const FileRun&);

}  // namespace seam::report
