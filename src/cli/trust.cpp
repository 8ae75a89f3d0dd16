// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/one_claim.h"

namespace seam::cli {

int trust(const std::string& file, const std::string& id, const VerifyOptions& options) {
  const Verified verified = one_claim(file, id, options);
  const report::ClaimRun& claim = find(verified.run, id);
  std::cout << id << ": " << report::word(claim.printed.verdict) << "\n\n"
            << "To believe this you have to believe\n"
            << "- that the statement says what the paper says:\n    " << claim.printed.text
            << "\n"
            << "- that these obligations are what it means (digest "
            << claim.printed.digest.substr(0, 16) << "):\n";
  for (const auto& o : claim.printed.obligations)
    std::cout << "    " << status_word(o.status) << "  " << o.text
              << (o.about.empty() ? "" : "  [" + o.about + "]") << "\n";
  std::cout << "- the meaning of the definitions and predicates it uses (docs/language.md)";
  for (const std::string& predicate : claim.predicates) std::cout << " " << predicate;
  std::cout << "\n- the checker, seamproof-check, its Boost.Multiprecision integers and the "
               "compiler.\n"
            << "You need not believe the prover or its libraries (GiNaC, CLN, FLINT, Arb, GMP) "
               "for the verdict; geometry and the\n"
            << "reading of the file use GMP, FLINT and Arb to build the obligations.\n";
  for (const std::string& used : claim.using_claims)
    std::cout << "It rests on the claim " << used << ": "
              << report::word(find(verified.run, used).printed.verdict) << "\n";
  return ok;
}

}  // namespace seam::cli
