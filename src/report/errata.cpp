// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/errata.h"

#include <algorithm>

// "Should read" may be said of what was proven, and of certified digits; of nothing else.

namespace seam::report {
namespace {

void add(std::vector<ErrataPlace>& places, const ClaimRun& claim) {
  const std::string at = claim.at.empty() ? "without a place" : claim.at;
  auto place = std::ranges::find(places, at, &ErrataPlace::at);
  if (place == places.end()) place = places.insert(place, {at, {}});
  place->claims.push_back(&claim);
}

}  // namespace

RightVersion right_version(const ClaimRun& claim) {
  if (claim.corrected && claim.corrected->verdict == Verdict::proven)
    return RightVersion::correction;
  if (!claim.true_digits.empty()) return RightVersion::digits;
  return claim.corrected ? RightVersion::unproven : RightVersion::none;
}

Errata errata(const FileRun& file) {
  Errata result;
  for (const ClaimRun* claim : claims(file)) {
    if (claim->printed.verdict != Verdict::refuted) continue;
    const RightVersion right = right_version(*claim);
    const bool is_known = right == RightVersion::correction || right == RightVersion::digits;
    add(is_known ? result.known : result.others, *claim);
  }
  return result;
}

}  // namespace seam::report
