// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace seam::report {

/// What a command without arguments stands for. `text` is UTF-8 and needs no escaping but for
/// `<`, `>` and `&`.
struct Symbol {
  enum class Kind {
    none,        ///< not a command that is known
    identifier,  ///< a letter
    upright,     ///< an upright letter or sign
    function,    ///< an upright name: `sin`
    sign,        ///< between two operands, or in front of one: `±`
    limits,      ///< an upright name or a large sign with what stands below and above it: `max`
    operation,   ///< an operator or a relation with blanks around it
    breaking,    ///< such a one behind which a line may end
    open,
    close,
    fence,  ///< opens or closes
    punctuation,
    blank,    ///< text: its width in CSS
    nothing,  ///< not seen: `\displaystyle`
    may_end   ///< a line may end here
  };
  Kind kind = Kind::none;
  std::string_view text;
};

/// By its name without the backslash.
Symbol symbol(std::string_view command);

/// The accent above its argument: `ˆ` of `hat`; empty if the command is none.
std::string_view accent(std::string_view command);

}  // namespace seam::report
