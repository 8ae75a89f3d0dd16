// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "report/mathml_row.h"

namespace seam::report {

/// `<mo attributes>sign</mo>`
std::string mathml_operator(std::string_view sign, const char* attributes = "");

/// `<mi attributes>name</mi>`
std::string mathml_identifier(std::string_view name, const char* attributes = "");

/// A character that stands for itself, but for letters and digits; nothing if it does not.
std::optional<MathmlAtom> mathml_sign(char);

/// A command without arguments, by its name; nothing if it is not known.
std::optional<MathmlAtom> mathml_command(std::string_view name);

}  // namespace seam::report
