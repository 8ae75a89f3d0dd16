// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace seam::cli {

/// In hexadecimal: the version, and what the linker made of exactly this program. Two builds
/// that could search differently have different names.
std::string build_name();

}  // namespace seam::cli
