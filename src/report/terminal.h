// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "report/run.h"

namespace seam::report {

/// `full`: of each claim also the methods, the number of obligations, whether evidence was
/// searched for or stored by an earlier run, and the least slack.
enum class Detail { brief, full };

enum class Colour { automatic, always, never };

/// Whether to colour: `automatic` does so on a terminal, unless NO_COLOR is set and not empty.
bool wants_colour(Colour, bool is_terminal, const char* no_color);

/// `✗ refuted    ID  witness  0.12 s`: shape and word of the verdict, the id, the reason or the
/// witness, what became of a correction, and what was expected if it was something else. One
/// line, with its end.
std::string line(const ClaimRun&, bool colour, Detail = Detail::brief);

/// `= ID  decimal  (closed form)  0.12 s`.
std::string line(const AskRun&, bool colour);

/// `61 claims: 55 proven, 6 refuted, 0 conditional, 0 undecided; 61 as expected`.
std::string line(const Summary&, bool colour);

/// The lines of all claims and questions in file order; if `full`, the claims with the least
/// slack; then the summary.
std::string terminal(const Run&, bool colour, Detail = Detail::brief);

/// `a.seam:3:7: warning: sentence [rule]`, and a hint, of each warning.
std::string warnings(const Run&);

/// `✓`, `✗`, `◐`, `?`.
const char* shape(Verdict);

}  // namespace seam::report
