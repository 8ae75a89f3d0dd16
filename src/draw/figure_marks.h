// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "claims/meaning.h"
#include "report/run.h"

namespace seam::draw {

/// Marks on the figures of a finished run where claims are refuted: the point of a patch that a
/// figure shows, where the claim names that patch by its name in the file, and the witness says
/// at which parameters. Of other refuted claims there is no mark.
void mark_refutations(report::FileRun&, const claims::Meaning&);

}  // namespace seam::draw
