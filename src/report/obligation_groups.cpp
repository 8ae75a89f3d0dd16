// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/obligation_groups.h"

#include <algorithm>
#include <map>

namespace seam::report {
namespace {

bool alike(const ObligationRun& a, const ObligationRun& b) {
  return a.about == b.about && a.kind == b.kind && a.guard == b.guard && a.status == b.status;
}

}  // namespace

std::vector<ObligationGroup> grouped(const std::vector<ObligationRun>& obligations) {
  std::vector<ObligationGroup> groups;
  for (const ObligationRun& obligation : obligations) {
    auto group = std::ranges::find_if(
        groups, [&](const ObligationGroup& g) { return alike(*g.first, obligation); });
    if (group == groups.end()) group = groups.insert(group, {&obligation, 0, {}});
    ++group->count;
    if (std::ranges::find(group->evidence, obligation.evidence) == group->evidence.end())
      group->evidence.push_back(obligation.evidence);
  }
  return groups;
}

const char* name(ObligationRun::Status status) {
  switch (status) {
    case ObligationRun::Status::holds:
      return "holds";
    case ObligationRun::Status::fails:
      return "fails";
    case ObligationRun::Status::open:
      break;
  }
  return "open";
}

std::string about(const ObligationRun& obligation) {
  if (!obligation.about.empty()) return obligation.about;
  static const std::map<std::string, std::string> words = {
      {"zero", "an identity"},          {"sign", "a sign"},
      {"solutions", "all solutions"},   {"gluing", "how the patches are glued"},
      {"distinct", "no two are equal"}, {"mesh", "what is counted on the mesh"}};
  const auto known = words.find(obligation.kind);
  return known == words.end() ? obligation.kind : known->second;
}

}  // namespace seam::report
