// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "certificate/evidence.h"
#include "report/run.h"

namespace seam::cli {

struct VerifyOptions {
  std::vector<std::string> claims;  ///< ids or globs; empty: all
  int jobs = 1;
  double timeout = 300;  ///< seconds that each step of a statement may take
  long memory = 0;       ///< mebibytes that it may take; 0: any
  long effort = 20'000;
  std::string store;  ///< folder of evidence of earlier runs; empty: none
};

/// A file with every selected claim decided, and its certificates by file name.
struct Verified {
  enum class Extent { whole, selection };  ///< of the claims of the file
  report::FileRun run;
  std::map<std::string, certificate::Certificate> certificates;
  Extent extent = Extent::whole;
};

/// `progress` is told, from any thread, how many statements are done, of how many, and the id
/// of the last.
using Progress = std::function<void(int done, int all, const std::string& id)>;

/// The same result for any number of jobs. Throws `Failure` for a file with errors.
Verified verify(const std::filesystem::path& file, const VerifyOptions&, const Progress&);

/// Where the certificate of this name goes, in the folder of a report.
std::string certificate_file(std::string name);

/// Whether an id is one of the ids or matches one of the globs (`*`, `?`).
bool selected(const std::string& id, const std::vector<std::string>& patterns);

}  // namespace seam::cli
