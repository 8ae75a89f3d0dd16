// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <sstream>

#include "certificate/json.h"
#include "claims/ids.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "cli/supervisor.h"

namespace seam::cli {
namespace fs = std::filesystem;

int list_claims(const std::vector<std::string>& files) {
  for (const fs::path& file : seam_files(files)) {
    for (const auto& claim : claims::named_claims(parsed(file), opener_beside(file)))
      std::cout << claim.id << "\n";
  }
  return ok;
}

int list_obligations(const std::vector<std::string>& files) {
  std::ostringstream lines;
  for (const fs::path& file : seam_files(files)) {
    const claims::Meaning meaning = meant(file, limits({}, file.string()));
    const auto print = [&](const std::string& id, const claims::Lowered& lowered) {
      std::string digest = lowered.reason;
      if (lowered.exported) digest = certificate::digest(lowered.exported->statement);
      digest.resize(16, ' ');
      lines << digest << "  " << id << "\n";
    };
    const auto print_claim = [&](const claims::MeantClaim& claim) {
      print(claim.claim.id, claim.printed);
      if (claim.corrected) print(claim.claim.id + " (corrected)", *claim.corrected);
    };
    for (const auto& item : meaning.items) {
      if (const auto* claim = std::get_if<claims::MeantClaim>(&item)) print_claim(*claim);
      if (const auto* table = std::get_if<claims::MeantTable>(&item))
        for (const auto& row : table->rows)
          for (const auto& cell : row.cells) print_claim(cell);
    }
  }
  std::cout << lines.str();
  return ok;
}

}  // namespace seam::cli
