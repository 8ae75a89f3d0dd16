// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/interrupts.h"
#include "cli/progress.h"

namespace seam::cli {
namespace fs = std::filesystem;

int verify_files(const std::vector<std::string>& arguments, const VerifyOptions& options,
                 const Outputs& outputs) {
  const std::vector<fs::path> files = seam_files(arguments);
  report::Run run{tool_name(), {}, libraries()};
  end_on_signals();
  for (const fs::path& file : files) {
    ProgressLine progress(outputs.quiet);
    const auto tell = [&](int done, int all, const std::string& id) {
      progress(done, all, id);
    };
    Verified verified;
    try {
      verified = verify(file, options, tell);
    } catch (const Failure& failure) {
      run.files.push_back(unread(file, failure));
      write_run(run, outputs);
      throw;
    }
    if (!outputs.out.empty()) {
      const fs::path folder =
          files.size() == 1 ? fs::path(outputs.out) : fs::path(outputs.out) / file.stem();
      write_folder(folder, verified, outputs);
    }
    run.files.push_back(std::move(verified.run));
  }
  const bool nothing =
      std::ranges::all_of(run.files, [](const auto& f) { return report::claims(f).empty(); });
  if (nothing && !options.claims.empty()) throw Failure{usage, "no claim has such an id\n"};
  write_run(run, outputs);
  tell_alarms(run);
  return report::exit_status(run, outputs.allow_undecided);
}

}  // namespace seam::cli
