// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/facets.h"
#include "geometry/surface.h"

// Each adds samples of one kind of value to a figure. What the figure is coloured by is set
// before.
namespace seam::cli {

/// Patches in space without parameters, seams between them, their other sides, and, if wanted,
/// their nets and lines of curvature.
struct SurfaceLines {
  bool net = false, curvature = false;
};
void add_patches(report::FigureRun&, const std::vector<geometry::Patch>&,
                 const std::vector<geometry::Seam>&, const SurfaceLines&,
                 const symbolic::Numbers&);

void add_mesh(report::FigureRun&, const geometry::Mesh&, const symbolic::Numbers&);

}  // namespace seam::cli
