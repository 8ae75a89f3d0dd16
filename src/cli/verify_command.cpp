// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <iostream>

#include "claims/ids.h"
#include "cli/commands.h"
#include "cli/files.h"
#include "cli/interrupts.h"
#include "cli/progress.h"
#include "report/terminal.h"

namespace seam::cli {
namespace fs = std::filesystem;
namespace {

// The ids of claims and questions, and of tables, which are those of no claim.
struct Ids {
  std::vector<std::string> claims, tables;
};

Ids ids_of(const std::vector<fs::path>& files) {
  Ids ids;
  for (const fs::path& file : files) {
    const claims::File parsed = claims::parse(open(file)).file;
    for (const auto& claim : claims::named_claims(parsed, opener_beside(file)))
      ids.claims.push_back(claim.id);
    for (const claims::Item& item : parsed.items) {
      if (item.kind == claims::Item::Kind::ask) ids.claims.push_back(item.name);
      if (item.kind == claims::Item::Kind::table) ids.tables.push_back(item.name);
    }
  }
  return ids;
}

// A slip in an id must not pass for a claim that holds.
void refuse_unknown(const std::vector<std::string>& patterns,
                    const std::vector<fs::path>& files) {
  const Ids ids = ids_of(files);
  for (const std::string& pattern : patterns) {
    const auto fits = [&](const std::string& id) { return selected(id, {pattern}); };
    if (std::ranges::any_of(ids.claims, fits)) continue;
    const std::string near = text::nearest(pattern, ids.claims);
    const bool is_table = std::ranges::find(ids.tables, pattern) != ids.tables.end();
    throw Failure{usage,
                  "no claim is named '" + pattern + "'" +
                      (is_table       ? "; for the cells of the table write '" + pattern + ".*'"
                       : near.empty() ? ""
                                      : "; did you mean '" + near + "'?") +
                      "\n"};
  }
}

}  // namespace

int verify_files(const std::vector<std::string>& arguments, const VerifyOptions& options,
                 const Outputs& outputs) {
  const std::vector<fs::path> files = seam_files(arguments);
  if (!options.claims.empty()) refuse_unknown(options.claims, files);
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
  write_run(run, outputs);
  if (!outputs.quiet) std::cerr << report::warnings(run);
  tell_alarms(run);
  return report::exit_status(run, outputs.allow_undecided);
}

}  // namespace seam::cli
