// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace seam::text {

struct CodePoint {
  char32_t value;
  std::size_t length;  ///< in bytes; 0: what stands there is not UTF-8
};

/// The code point that begins at `offset`, which must be inside the bytes.
CodePoint decode(std::string_view bytes, std::size_t offset);

/// Where the bytes stop being UTF-8, if they do.
std::optional<std::size_t> invalid_utf8(std::string_view bytes);

/// A control other than tab and line ends, or a mark that reorders the text
/// around it: nothing that a reader could see, so no text to be trusted holds one.
bool invisible(char32_t);

/// `U+00E9`
std::string code_name(char32_t);

/// The same text, safe to show on a terminal: each tab a blank, each invisible
/// character, line end or stray byte one replacement character.
std::string printable(std::string_view bytes);

}  // namespace seam::text
