// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/outputs.h"

#include "certificate/json.h"
#include "check/library.h"
#include "cli/files.h"
#include "report/figure.h"
#include "report/file.h"
#include "report/fragments.h"
#include "report/gltf.h"
#include "report/html.h"
#include "report/json.h"
#include "report/latex.h"
#include "report/pdf.h"
#include "report/svg.h"
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

namespace {

void check(const std::optional<report::FileError>& error) {
  if (error) throw Failure{io_error, error->message + "\n"};
}

void write_figures(const fs::path& folder, const report::FileRun& run, bool pdf) {
  for (const auto& [name, figure] : report::figures(run)) {
    write(folder / (name + ".svg"), report::svg(*figure));
    write(folder / (name + ".glb"), report::glb(*figure));
    if (pdf) check(report::typeset(report::page(*figure), folder / (name + ".pdf")));
  }
}

}  // namespace

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
  write_figures(folder / "figures", verified.run, outputs.pdf);
  if (outputs.pdf) check(report::typeset(folder / "report.tex"));
}

}  // namespace seam::cli
