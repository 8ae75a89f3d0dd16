// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "claims/meaning.h"
#include "draw/facets.h"
#include "draw/rounded_function.h"

// Each adds samples of one kind of value to a figure, and what the file wants drawn with it.
namespace seam::draw {

/// Patches in space without parameters, with the seams between them.
void add_patches(report::FigureRun&, const std::vector<geometry::Patch>&,
                 const std::vector<geometry::Seam>&, const claims::MeantFigure&,
                 const symbolic::Numbers&);

void add_mesh(report::FigureRun&, const geometry::Mesh&, const symbolic::Numbers&);

void add_curve(report::FigureRun&, const geometry::Curve&, const claims::MeantFigure&,
               const symbolic::Numbers&);

/// Graphs, curves and surfaces that functions over a domain are.
void add_functions(report::FigureRun&, const claims::MeantFigure&, const symbolic::Numbers&);

/// The colour the file wants of a patch or function of that number, in variables with these
/// values; nothing if it wants none, or one that such a surface does not have.
Colouring colouring(const claims::MeantFigure&, std::size_t number,
                    const std::vector<std::string>& variables,
                    const std::function<std::vector<Expansion>(double u, double v)>& values,
                    const symbolic::Numbers&);

/// Lines on the facets where the value is a tick of the scale of all values.
void add_contours(report::FigureRun&);

/// Lines of curvature of a sheet, from a few points of it.
void add_curvature_lines(report::FigureRun&, const Sheet&);

}  // namespace seam::draw
