// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "report/run.h"

namespace seam::report {

/// The drawing of a figure as a tikzpicture, in the middle of the line; empty if there is
/// nothing to see. Numbers are rounded to a few digits, so that equal figures give equal bytes.
std::string picture(const FigureRun&);

/// A LaTeX document of one page, cut to the drawing.
std::string page(const FigureRun&);

/// The figures of a file, each with a name that no other has: its id, or its title in small
/// letters, digits and hyphens. For the names of files.
struct NamedFigure {
  std::string name;
  const FigureRun* figure = nullptr;
};
std::vector<NamedFigure> figures(const FileRun&);

}  // namespace seam::report
