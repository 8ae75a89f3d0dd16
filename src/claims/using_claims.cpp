// SPDX-License-Identifier: GPL-3.0-or-later
#include <functional>

#include "claims/item_reader.h"

namespace seam::claims {

// Every id that is used is the id of a claim, and no claim rests on itself.
void Reader::check_using() {
  std::map<std::string, const MeantClaim*> claims;
  std::vector<std::string> ids;
  for (const MeantItem& item : meaning_.items)
    if (const auto* claim = std::get_if<MeantClaim>(&item)) {
      claims.emplace(claim->claim.id, claim);
      ids.push_back(claim->claim.id);
    }
  std::map<std::string, int> state;  // 1: on the way, 2: done
  const auto visit = [&](auto&& self, const MeantClaim& claim) -> void {
    state[claim.claim.id] = 1;
    for (const std::string& used : claim.claim.using_claims) {
      const auto found = claims.find(used);
      if (found == claims.end()) {
        const std::string near = text::nearest(used, ids);
        report({claim.span, "this claim uses '" + used + "', which is no claim",
                near.empty() ? "" : "did you mean '" + near + "'?"});
      } else if (state[used] == 1) {
        report({claim.span,
                "circular 'using': '" + claim.claim.id + "' rests on itself by way of '" +
                    used + "'",
                {}});
      } else if (state[used] == 0) {
        self(self, *found->second);
      }
    }
    state[claim.claim.id] = 2;
  };
  for (const MeantItem& item : meaning_.items)
    if (const auto* claim = std::get_if<MeantClaim>(&item);
        claim && state[claim->claim.id] == 0)
      visit(visit, *claim);
}

}  // namespace seam::claims
