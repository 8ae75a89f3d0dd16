// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

namespace seam::report {

/// Red, green, blue, from 0 to 1.
using Colour = std::array<double, 3>;

/// How values are told by colours. Values far beyond the bulk of the others share the colour of
/// the end that they lie behind.
struct Scale {
  double low = 0, high = 0;           ///< equal where all values are
  double least = 0, greatest = 0;     ///< of all values
  bool below = false, above = false;  ///< there are values behind that end
  bool diverging = false;             ///< of both signs: 0 has the neutral colour
  std::vector<double> ticks;          ///< round numbers, at most 7, in [low, high]
};
Scale scale_of(std::vector<double> values);

/// Of one sign: even steps from dark to light (viridis); of both: from blue over grey to red
/// (Moreland's cool to warm). Both read with colour-blind eyes.
Colour colour(const Scale&, double value);

/// `0.25`, `-3`, `1.2e-05`: to four digits.
std::string short_number(double);

}  // namespace seam::report
