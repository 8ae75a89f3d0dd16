// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include <string>

namespace seam::text {

/// Called first in a program: where it was started without standard input, output or error, no
/// file that it opens takes their place; and what is then written to standard output fails.
void hold_standard_streams();

/// Writes what is left of standard output. Empty, or why not all of it was written.
std::string end_of_output();

}  // namespace seam::text
