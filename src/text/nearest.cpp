// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <algorithm>

#include "text/source.h"

// The distance is that of optimal string alignment: the least number of
// letters put in, left out, replaced, or exchanged with their neighbour, where no
// stretch is changed twice. A word longer than `longest` is nobody's slip.

namespace seam::text {
namespace {

constexpr std::size_t longest = 100;

std::size_t distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> two_above, above(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    two_above = above;
    above = row;
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], two_above[j - 2] + 1);
    }
  }
  return row[b.size()];
}

}  // namespace

std::string nearest(std::string_view name, const std::vector<std::string>& known) {
  const std::size_t bound = std::min<std::size_t>(name.size() / 3, 3);
  if (bound == 0 || name.size() > longest) return {};
  std::size_t best = bound + 1;
  std::string found;
  for (const std::string& candidate : known) {
    const std::size_t lengths = candidate.size() > name.size() ? candidate.size() - name.size()
                                                               : name.size() - candidate.size();
    if (lengths >= best) continue;
    const std::size_t d = distance(name, candidate);
    if (d < best) {
      best = d;
      found = candidate;
    }
  }
  return found;
}

}  // namespace seam::text
