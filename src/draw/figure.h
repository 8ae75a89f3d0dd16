// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "claims/meaning.h"
#include "report/run.h"

namespace seam::draw {

/// A drawing of samples: patches and surfaces cut into small facets, rounded. Proves nothing.
report::FigureRun sampled(const claims::MeantFigure&, const symbolic::Numbers&);

}  // namespace seam::draw
