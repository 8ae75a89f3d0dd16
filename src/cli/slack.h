// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "claims/export.h"
#include "report/run.h"

namespace seam::cli {

/// Says of each inequality that a proven statement asserts by how much it holds. Guards and
/// what is denied are left out.
void add_slacks(report::Outcome&, const claims::Exported&);

}  // namespace seam::cli
