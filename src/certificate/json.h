// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

#include "certificate/evidence.h"

namespace seam::certificate {

/// The text is not a certificate: where, and what was expected there.
struct FormatError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The longest text that is read.
inline constexpr std::size_t max_bytes = std::size_t{64} << 20;

/// One JSON document with a final newline. Deterministic: equal values, equal bytes.
std::string write(const Certificate&);

/// Reads what `write` writes: read(write(c)) == c. Any bytes may be passed in; text that is
/// not a certificate, or whose indices point outside it or forward, throws `FormatError`.
Certificate read(std::string_view text);

/// SHA-256, in hexadecimal, of the canonical text of the statement: what was claimed,
/// whatever the evidence.
std::string digest(const Statement&);

}  // namespace seam::certificate
