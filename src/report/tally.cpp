// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/tally.h"

#include <algorithm>

namespace seam::report {

std::vector<Tally> by_section(const FileRun& file) {
  std::vector<Tally> tallies;
  FileRun part;
  std::string title = "before the first section";
  int number = 0;
  const auto finish = [&] {
    const Summary summary = summarize(part);
    if (summary.claims > 0) tallies.push_back({title, number, summary});
    part.items.clear();
  };
  for (const ItemRun& item : file.items) {
    if (const auto* section = std::get_if<SectionRun>(&item)) {
      finish();
      title = section->title;
      ++number;
    } else {
      part.items.push_back(item);
    }
  }
  finish();
  return tallies;
}

std::string sentence(const Summary& summary) {
  return "Of " + std::to_string(summary.claims) +
         (summary.claims == 1 ? " claim, " : " claims, ") + std::to_string(summary.proven) +
         " proven, " + std::to_string(summary.refuted) + " refuted, " +
         std::to_string(summary.conditional) + " conditional and " +
         std::to_string(summary.undecided) + " undecided; " +
         std::to_string(summary.as_expected) + (summary.as_expected == 1 ? " is" : " are") +
         " as the author of the file expects.";
}

bool has_alarm(const FileRun& file) {
  return std::ranges::any_of(claims(file), [](const ClaimRun* claim) {
    return !claim->printed.alarm.empty() ||
           (claim->corrected && !claim->corrected->alarm.empty());
  });
}

}  // namespace seam::report
