// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

#include "cli/verify.h"
#include "report/mutation_run.h"

namespace seam::cli {

struct MutateOptions {
  std::uint64_t seed = 1;
  int count = 100;    ///< mutants of all claims together
  int per_claim = 0;  ///< instead: of each claim
};

/// How much the selected claims of a file notice, and each mutant that was decided with another
/// statement: as a .seam file, with its certificates, by file name.
struct Mutated {
  report::MutationRun run;
  std::map<std::string, std::string> files;
};

/// The same for any number of jobs, except for what runs out of time or memory. Throws
/// `Failure` for a file with errors, and where no claim is selected.
Mutated mutate(const std::filesystem::path& file, const MutateOptions&, const VerifyOptions&,
               const Progress&);

}  // namespace seam::cli
