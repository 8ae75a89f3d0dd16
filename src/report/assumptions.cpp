// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/assumptions.h"

#include <algorithm>

namespace seam::report {
namespace {

using Claims = std::vector<const ClaimRun*>;

bool speaks_of(const ClaimRun& claim, const DefinitionRun& definition) {
  return std::ranges::any_of(definition.names, [&](const std::string& name) {
    return std::ranges::find(claim.definitions, name) != claim.definitions.end();
  });
}

void add_parameters(Assumptions& result, const FileRun& file, const Claims& all) {
  for (const ItemRun& item : file.items) {
    const auto* definition = std::get_if<DefinitionRun>(&item);
    if (!definition || !definition->is_parameter) continue;
    const auto count = std::ranges::count_if(
        all, [&](const ClaimRun* claim) { return speaks_of(*claim, *definition); });
    if (count > 0) result.parameters.push_back({definition, static_cast<int>(count)});
  }
}

void add_guards(Assumptions& result, const ClaimRun& claim, const Outcome& outcome) {
  for (const ObligationRun& guard : outcome.obligations) {
    if (!guard.guard) continue;
    if (guard.status == ObligationRun::Status::holds)
      ++result.guards_proven;
    else
      result.guards_not_proven.push_back({&claim, &guard});
  }
}

void add_uses(Assumptions& result, const ClaimRun& claim, const Claims& all) {
  if (claim.using_claims.empty()) return;
  Assumptions::Use use{&claim, {}};
  for (const std::string& id : claim.using_claims) {
    const auto found = std::ranges::find(all, id, &ClaimRun::id);
    use.rests_on.push_back({id, found == all.end() ? nullptr : *found});
  }
  result.uses.push_back(std::move(use));
}

}  // namespace

bool Assumptions::empty() const {
  return parameters.empty() && guards_proven == 0 && guards_not_proven.empty() && uses.empty();
}

Assumptions assumptions(const FileRun& file) {
  Assumptions result;
  const Claims all = claims(file);
  add_parameters(result, file, all);
  for (const ClaimRun* claim : all) {
    add_guards(result, *claim, claim->printed);
    if (claim->corrected) add_guards(result, *claim, *claim->corrected);
    add_uses(result, *claim, all);
  }
  return result;
}

}  // namespace seam::report
