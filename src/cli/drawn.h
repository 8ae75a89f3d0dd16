// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "claims/meaning.h"
#include "report/run.h"

namespace seam::cli {

/// The drawing of a figure that has so many items before it. One that takes more than the
/// limits is empty and says so.
report::FigureRun drawn(const claims::MeantFigure&, const symbolic::Numbers&,
                        std::size_t before, const claims::Limits&);

}  // namespace seam::cli
