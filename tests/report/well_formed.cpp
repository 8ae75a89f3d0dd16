// SPDX-License-Identifier: GPL-3.0-or-later
#include "well_formed.h"

#include <vector>

namespace seam::report {

std::string not_well_formed(std::string_view markup) {
  std::vector<std::string> open;
  for (std::size_t at = 0; at < markup.size();) {
    if (markup[at] == '>') return "a stray >";
    if (markup[at] == '&') {
      const std::size_t end = markup.find(';', at);
      if (end == markup.npos || end - at > 8) return "a stray &";
    }
    if (markup[at] != '<') {
      ++at;
      continue;
    }
    const std::size_t end = markup.find('>', at);
    if (end == markup.npos) return "a tag that does not end";
    std::string tag(markup.substr(at + 1, end - at - 1));
    at = end + 1;
    if (tag.ends_with('/') || tag.starts_with('!')) continue;
    if (!tag.starts_with('/')) {
      open.push_back(tag.substr(0, tag.find(' ')));
    } else if (open.empty() || open.back() != tag.substr(1)) {
      return "</" + tag.substr(1) + "> closes nothing";
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : "<" + open.back() + "> is not closed";
}

}  // namespace seam::report
