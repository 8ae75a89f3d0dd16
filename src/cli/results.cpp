// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/results.h"

#include "cli/files.h"
#include "report/read_json.h"
#include "text/utf8.h"

namespace seam::cli {
namespace fs = std::filesystem;

bool has_results(const fs::path& folder) {
  std::error_code error;
  return fs::is_regular_file(folder / "results.json", error);
}

report::Run results_in(const fs::path& folder) {
  const fs::path path = folder / "results.json";
  auto read = report::read_json(open(path)->bytes);
  if (const auto* error = std::get_if<report::JsonError>(&read))
    throw Failure{bad_file, path.string() + ": " +
                                (error->where.empty() ? "" : error->where + ": ") +
                                "error: " + text::printable(error->message) + "\n" +
                                (error->hint.empty() ? "" : "  hint: " + error->hint + "\n")};
  auto run = std::get<report::Run>(std::move(read));
  if (run.files.size() != 1)
    throw Failure{bad_file, path.string() +
                                ": files: error: expected the results of one file, "
                                "as `verify --out` writes them\n"};
  return run;
}

}  // namespace seam::cli
