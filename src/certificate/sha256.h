// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include <string>
#include <string_view>

namespace seam::certificate {

/// SHA-256 (FIPS 180-4) of the bytes, 64 hexadecimal digits.
std::string sha256(std::string_view bytes);

}  // namespace seam::certificate
