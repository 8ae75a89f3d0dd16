// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "claims/syntax.h"

namespace seam::claims {

/// An expression or a statement as mathematics, for between dollar signs; needs amsmath and
/// amssymb. Printable ASCII without `$`, `%`, `#` and `"`, save behind a backslash; braces and
/// fences are nested properly, and never so deep that TeX gives up. Any tree that `parse` can
/// make may be passed in.
std::string latex(const Expression&);

/// What an item defines: `f(x) = E`, `c \in (0, 1)`; empty for items that define nothing.
std::string latex(const Item&);

/// A name: `gamma_f1` is \gamma_{f1}, `x0` is x_{0}, `K_max` is K_{\mathrm{max}}. A word of
/// several letters is upright where it is called (`operation`), else slanted.
std::string latex_name(std::string_view name, bool operation = false);

/// Any text inside a formula; what has no place in a formula is shown by its number,
/// `[U+4E2D]`.
std::string latex_text(std::string_view text);

}  // namespace seam::claims
