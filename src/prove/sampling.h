// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "prove/region.h"

namespace seam::prove {

/// The polynomial's value, about.
double about(const exact::Polynomial&, const std::vector<double>& values);

/// Points of a product of factors, and of the real line for each of so many variables behind
/// them, in doubles: to see at a glance what is not worth a proof.
std::vector<std::vector<double>> sample(const Factors&, std::size_t lines, int count);

}  // namespace seam::prove
