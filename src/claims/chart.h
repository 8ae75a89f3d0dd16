// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "claims/evaluate.h"
#include "geometry/chart.h"

namespace seam::claims {

/// A patch, a function on one, or a function of two numbers, as a surface; its points have any
/// dimension. Nothing for other values.
std::optional<geometry::Chart> chart_of(Evaluator&, const Value&);

/// A curve, a function on one, or a function of one number.
std::optional<geometry::Arc> arc_of(Evaluator&, const Value&);

/// The domain of a patch of this shape, in the parameters of geometry.
symbolic::Domain domain_of(geometry::Patch::Shape);

}  // namespace seam::claims
