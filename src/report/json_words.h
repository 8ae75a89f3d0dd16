// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

#include "report/run.h"

// The words for what is one of a few, in the order of the values.
namespace seam::report {

inline constexpr std::array<std::string_view, 4> words(Verdict) {
  return {"proven", "refuted", "conditional", "undecided"};
}

inline constexpr std::array<std::string_view, 3> words(ObligationRun::Status) {
  return {"holds", "fails", "open"};
}

inline constexpr std::array<std::string_view, 6> words(FigureRun::Line::Kind) {
  return {"seam", "edge", "net", "curvature", "curve", "contour"};
}

}  // namespace seam::report
