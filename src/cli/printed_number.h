// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "claims/named_numbers.h"

namespace seam::cli {

/// A number as LaTeX prints it: `-0.2857`, `{0.2857}`, `0.28\,57`, `1.58\ldots` (cut off),
/// `1.50\times10^{-3}`, `1.5e-3`, `\num{1.5e-3}`. Nothing if it prints anything else; so
/// `10^12`, which prints the 2 beside the power, and commas, which mean one thing here and
/// another there, are no numbers.
std::optional<claims::PrintedNumber> printed_number(std::string_view latex);

}  // namespace seam::cli
