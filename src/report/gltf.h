// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/run.h"

namespace seam::report {

/// The figure as a model in space, in the binary form of glTF 2.0: facets with normals and
/// colours, lines and marks as primitives of their own; z points up. Its extras say that it is
/// a drawing of samples. Without facets, lines and marks: a scene with nothing in it.
std::string glb(const FigureRun&);

}  // namespace seam::report
