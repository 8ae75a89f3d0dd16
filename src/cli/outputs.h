// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "cli/files.h"
#include "cli/verify.h"

namespace seam::cli {

/// Where the results of a run go, and what is said of them.
struct Outputs {
  std::string out;   ///< a folder for report.tex, results.json, certificates/; empty: none
  std::string json;  ///< a file, `-` for standard output; empty: none
  std::string junit, sarif;  ///< likewise
  bool github = false;       ///< workflow commands and the summary of a job
  bool pdf = false;
  bool html = false;
  bool fragments = false;
  bool allow_undecided = false;
  bool quiet = false;
  bool verbose = false;
  std::string colour = "auto";
};

/// `seamproof 0.1.0`
std::string tool_name();

/// The libraries at work, with their versions; the checker's own last.
std::vector<std::string> libraries();

/// The whole file or none of it. Throws `Failure` (74).
void write(const std::filesystem::path&, const std::string& bytes);

/// A file that could not be read, as a run that says so.
report::FileRun unread(const std::filesystem::path&, const Failure&);

/// What people and CI systems read, where `Outputs` says.
void write_run(const report::Run&, const Outputs&);

/// The evidence to which the checker objected, on standard error.
void tell_alarms(const report::Run&);

/// The folder of one verified file: its certificates, results.json and the report, which is
/// made from these results. `made_by` is a run without files: the tool and the libraries.
void write_folder(const std::filesystem::path& folder, const Verified&, const Outputs&,
                  const report::Run& made_by = {tool_name(), {}, libraries()});

}  // namespace seam::cli
