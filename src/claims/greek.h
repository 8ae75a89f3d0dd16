// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace seam::claims {

/// The English name of a Greek letter (`alpha`, `Gamma`); empty for other characters.
std::string_view greek_name(char32_t);

/// Is this the English name of a Greek letter?
bool is_greek_name(std::string_view);

/// A name with its Greek letters spelled out: `γ_f1` is `gamma_f1`.
std::string spelled_out(std::string_view name);

}  // namespace seam::claims
