// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/outputs.h"

#include "certificate/json.h"
#include "check/library.h"
#include "cli/files.h"
#include "report/file.h"
#include "report/fragments.h"
#include "report/html.h"
#include "report/json.h"
#include "report/latex.h"
#include "report/pdf.h"
#include "symbolic/libraries.h"

namespace seam::cli {
namespace fs = std::filesystem;

std::string tool_name() {
  return std::string("seamproof ") + SEAMPROOF_VERSION;
}

std::vector<std::string> libraries() {
  std::vector<std::string> all = symbolic::libraries();
  all.push_back(check::library());
  return all;
}

void write(const fs::path& path, const std::string& bytes) {
  if (const auto error = report::write_file(path, bytes))
    throw Failure{io_error, error->message + "\n"};
}

void write_folder(const fs::path& folder, const Verified& verified, const Outputs& outputs) {
  const report::Run run{tool_name(), {verified.run}, libraries()};
  for (const auto& [name, certificate] : verified.certificates)
    write(folder / name, certificate::write(certificate));
  write(folder / "results.json", report::json(run));
  write(folder / "report.tex", report::latex(run));
  if (outputs.html) write(folder / "report.html", report::html(run));
  if (outputs.fragments)
    for (const auto& [name, bytes] : report::fragments(verified.run))
      write(folder / "fragments" / name, bytes);
  if (!outputs.pdf) return;
  if (const auto error = report::typeset(folder / "report.tex"))
    throw Failure{io_error, error->message + "\n"};
}

}  // namespace seam::cli
