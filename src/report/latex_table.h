// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/run.h"

namespace seam::report {

/// A printed table again, with a mark in each cell, and where a cell is wrong the true digits.
std::string latex_table(const TableRun&);

}  // namespace seam::report
