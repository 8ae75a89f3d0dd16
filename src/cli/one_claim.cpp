// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/one_claim.h"

#include <algorithm>

#include "cli/files.h"
#include "cli/supervisor.h"

namespace seam::cli {

// The one claim of a file, with everything it uses.
Verified one_claim(const std::string& file, const std::string& id, VerifyOptions options) {
  const claims::Meaning meaning = meant(file, limits(options, file));
  std::vector<std::string> ids;
  std::map<std::string, std::vector<std::string>> uses;
  for (const auto& item : meaning.items) {
    if (const auto* claim = std::get_if<claims::MeantClaim>(&item)) {
      ids.push_back(claim->claim.id);
      uses[claim->claim.id] = claim->claim.using_claims;
    }
    if (const auto* table = std::get_if<claims::MeantTable>(&item))
      for (const auto& row : table->rows)
        for (const auto& cell : row.cells) ids.push_back(cell.claim.id);
  }
  if (std::ranges::find(ids, id) == ids.end()) {
    const std::string near = text::nearest(id, ids);
    throw Failure{usage, "no claim '" + id + "' in " + file +
                             (near.empty() ? "" : "; did you mean '" + near + "'?") + "\n"};
  }
  options.claims = {id};
  for (std::size_t i = 0; i < options.claims.size(); ++i)
    for (const std::string& used : uses[options.claims[i]])
      if (std::ranges::find(options.claims, used) == options.claims.end())
        options.claims.push_back(used);
  return verify(file, options, [](int, int, const std::string&) {});
}

const report::ClaimRun& find(const report::FileRun& run, const std::string& id) {
  for (const report::ClaimRun* claim : report::claims(run))
    if (claim->id == id) return *claim;
  throw Failure{internal, "the claim was lost\n"};
}

const char* status_word(report::ObligationRun::Status status) {
  if (status == report::ObligationRun::Status::holds) return "holds";
  return status == report::ObligationRun::Status::fails ? "fails" : "open";
}

}  // namespace seam::cli
