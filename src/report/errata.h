// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "report/run.h"

namespace seam::report {

/// What should stand where a claim is refuted.
enum class RightVersion {
  correction,  ///< the correction of the file: it is proven
  digits,      ///< the certified digits
  unproven,    ///< the correction of the file, which is not proven
  none,
};
RightVersion right_version(const ClaimRun&);

/// Refuted claims of one place in the paper.
struct ErrataPlace {
  std::string at;  ///< `§6`; `without a place`
  std::vector<const ClaimRun*> claims;
};

/// All refuted claims of a file, by places in the order in which the file comes to them.
struct Errata {
  std::vector<ErrataPlace> known;   ///< what should stand there is proven or certified
  std::vector<ErrataPlace> others;  ///< of these that cannot be said
};
Errata errata(const FileRun&);

/// What the heads of the two lists say.
inline constexpr const char* errata_known_title = "Errata";
inline constexpr const char* errata_known_words =
    "What is printed is refuted, and what should stand there is proven: each by evidence that "
    "the independent checker accepted.";
inline constexpr const char* errata_others_title = "Refuted, without a proven correction";

}  // namespace seam::report
