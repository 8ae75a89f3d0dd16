// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iostream>
#include <set>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/judge_again.h"
#include "cli/results.h"

// A folder that `verify --out` wrote is reported from its results.json and its certificates,
// without the prover; .seam files and folders of them are verified.

namespace seam::cli {
namespace fs = std::filesystem;
namespace {

std::string name_of(const fs::path& folder) {
  return fs::weakly_canonical(folder).filename().string();
}

}  // namespace

int report_files(const std::vector<std::string>& arguments, const VerifyOptions& options,
                 const Outputs& outputs) {
  const auto folders = std::ranges::count_if(arguments, has_results);
  if (folders == 0) return verify_files(arguments, options, outputs);
  if (folders != std::ssize(arguments))
    throw Failure{usage, "folders with a results.json, or .seam files, but not both at once\n"};
  std::set<std::string> names;
  for (const fs::path folder : arguments)
    if (!names.insert(name_of(folder)).second)
      throw Failure{usage, "two folders have the name '" + name_of(folder) + "'\n"};

  report::Run all{tool_name(), {}, libraries()};
  for (const fs::path folder : arguments) {
    const report::Run run = results_in(folder);
    Verified verified{run.files.front(), {}, Verified::Extent::selection};
    verified.certificates = judge_again(verified.run, folder, options.jobs);
    const fs::path out(outputs.out);
    write_folder(arguments.size() == 1 ? out : out / name_of(folder), verified, outputs,
                 {run.tool, {}, run.libraries});
    all.files.push_back(std::move(verified.run));
  }
  write_run(all, outputs);
  tell_alarms(all);
  return report::exit_status(all, outputs.allow_undecided);
}

}  // namespace seam::cli
