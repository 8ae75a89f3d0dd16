// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iostream>

#include "cli/commands.h"
#include "cli/interrupts.h"
#include "cli/progress.h"

namespace seam::cli {
namespace fs = std::filesystem;
namespace {

// An alarm, or a mutant on which the program broke off.
int status_of(const report::MutationRun& run) {
  int status = ok;
  for (const auto& claim : run.claims)
    for (const auto& mutant : claim.mutants) {
      const bool is_alarm = mutant.printed.reason.starts_with("alarm") ||
                            (mutant.corrected && mutant.corrected->reason.starts_with("alarm"));
      const bool is_internal = mutant.error.starts_with("internal error");
      if (is_alarm || is_internal)
        std::cerr << mutant.file << ":" << mutant.line << ":" << mutant.column << ": "
                  << (is_alarm ? mutant.printed.reason : mutant.error) << "\n  - "
                  << mutant.before << "\n  + " << mutant.after << "\n";
      if (is_internal) status = internal;
      if (is_alarm && status == ok) status = alarm;
    }
  return status;
}

}  // namespace

int mutate_file(const std::string& file, const MutateOptions& options,
                const VerifyOptions& search, const Outputs& outputs) {
  end_on_signals();
  ProgressLine progress(outputs.quiet);
  const Mutated mutated =
      mutate(file, options, search,
             [&](int done, int all, const std::string& id) { progress(done, all, id); });
  if (!outputs.json.empty() && outputs.json != "-")
    write(outputs.json, report::mutation_json(mutated.run));
  if (!outputs.out.empty()) {
    fs::create_directories(outputs.out);
    for (const auto& [name, bytes] : mutated.files) write(fs::path(outputs.out) / name, bytes);
  }
  if (outputs.json == "-")
    std::cout << report::mutation_json(mutated.run);
  else if (!outputs.quiet)
    std::cout << report::mutation_text(mutated.run);
  return status_of(mutated.run);
}

}  // namespace seam::cli
