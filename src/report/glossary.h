// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace seam::report {

struct GlossaryEntry {
  std::string predicate, latex;
};

/// What `proven` means for each of the predicates named, in the order of docs/language.md;
/// names that are not known to it are left out.
std::vector<GlossaryEntry> glossary(const std::vector<std::string>& predicates);

}  // namespace seam::report
