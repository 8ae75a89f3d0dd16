// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace seam::report {

/// A formula in the part of LaTeX that report/mathematics.h allows, as MathML Core: well-formed
/// `math` elements, with `<wbr/>` where a line may end between two of them (browsers break no
/// line inside one). Nothing if the formula holds something else; never broken markup.
std::optional<std::string> mathml(std::string_view latex);

}  // namespace seam::report
