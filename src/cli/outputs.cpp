// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/outputs.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <map>
#include <set>

#include "certificate/json.h"
#include "check/library.h"
#include "cli/files.h"
#include "cli/interrupts.h"
#include "cli/left_over.h"
#include "report/figure.h"
#include "report/file.h"
#include "report/fragments.h"
#include "report/github.h"
#include "report/gltf.h"
#include "report/html.h"
#include "report/json.h"
#include "report/junit.h"
#include "report/latex.h"
#include "report/pdf.h"
#include "report/read_json.h"
#include "report/sarif.h"
#include "report/svg.h"
#include "report/terminal.h"
#include "symbolic/libraries.h"
#include "text/utf8.h"

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

report::Colour colour_of(const std::string& word) {
  if (word == "always") return report::Colour::always;
  return word == "never" ? report::Colour::never : report::Colour::automatic;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// What was there before is another step's.
void append(const fs::path& path, const std::string& bytes) {
  std::ofstream file(path, std::ios::binary | std::ios::app);
  if (!(file << bytes << std::flush))
    throw Failure{io_error, "cannot write '" + path.string() + "'\n"};
}

}  // namespace

void write_folder(const fs::path& folder, const Verified& verified, const Outputs& outputs,
                  const report::Run& made_by) {
  const std::string results = report::json({made_by.tool, {verified.run}, made_by.libraries});
  const auto run = std::get<report::Run>(report::read_json(results));
  const report::FileRun& file = run.files.front();
  const Uninterrupted whole;
  remove_unfinished(folder);
  report::FileSet files;
  const auto add = [&](const fs::path& name, const std::string& bytes) {
    check(files.add(folder / name, bytes));
  };
  for (const auto& [name, certificate] : verified.certificates)
    add(name, certificate::write(certificate));
  const bool is_news = bytes_of(folder / "results.json") != results;
  add("report.tex", report::latex(run));
  if (outputs.html) add("report.html", report::html(run));
  const auto fragments =
      outputs.fragments ? report::fragments(file) : std::map<std::string, std::string>();
  for (const auto& [name, bytes] : fragments) add("fragments" / fs::path(name), bytes);
  const auto figures = report::figures(file);
  for (const auto& [name, figure] : figures) {
    add("figures" / fs::path(name + ".svg"), report::svg(*figure));
    add("figures" / fs::path(name + ".glb"), report::glb(*figure));
  }
  add("results.json", results);
  check(files.put_in_place());
  remove_vanished(folder, verified);
  if (outputs.pdf) {
    for (const auto& [name, figure] : figures)
      check(report::typeset(report::page(*figure), folder / "figures" / (name + ".pdf")));
    check(report::typeset(folder / "report.tex"));
  }
  std::set<std::string> written;
  for (const auto& [name, bytes] : fragments) written.insert("fragments/" + name);
  for (const auto& [name, figure] : figures)
    for (const char* kind : {".svg", ".glb", ".pdf"})
      if (outputs.pdf || std::string_view(kind) != ".pdf")
        written.insert("figures/" + (name + kind));
  if (outputs.html) written.insert("report.html");
  if (outputs.pdf) written.insert("report.pdf");
  if (is_news) remove_outdated(folder, written);
}

report::FileRun unread(const fs::path& file, const Failure& failure) {
  report::FileRun run;
  run.file = file.filename().string();
  run.path = file.string();
  for (const text::Diagnostic& error : failure.errors) {
    const text::Position place = text::position(*error.where.source, error.where.begin);
    const std::string& name = error.where.source->name;
    run.errors.push_back(
        {error.message, error.hint, place.line, place.column, name == run.path ? "" : name});
  }
  if (run.errors.empty()) run.errors.push_back({failure.message, "", 0, 0});
  return run;
}

void tell_alarms(const report::Run& run) {
  const auto tell = [](const std::string& id, const std::string& alarm) {
    if (!alarm.empty())
      std::cerr << "soundness alarm: " << text::printable(id)
                << ": the checker did not accept the evidence: " << text::printable(alarm)
                << "\n";
  };
  for (const auto& file : run.files) {
    for (const report::ClaimRun* claim : report::claims(file)) {
      tell(claim->id, claim->printed.alarm);
      if (claim->corrected) tell(claim->id, claim->corrected->alarm);
    }
    for (const auto& [id, alarm] : report::alarms_beside_claims(file)) tell(id, alarm);
  }
}

void write_run(const report::Run& run, const Outputs& outputs) {
  const bool allow = outputs.allow_undecided;
  const bool to_stdout = outputs.json == "-" || outputs.junit == "-" || outputs.sarif == "-";
  const auto put = [](const std::string& where, const std::string& bytes) {
    if (where == "-")
      std::cout << bytes;
    else
      write(where, bytes);
  };
  if (!outputs.json.empty()) put(outputs.json, report::json(run));
  if (!outputs.junit.empty()) put(outputs.junit, report::junit(run, allow));
  if (!outputs.sarif.empty()) put(outputs.sarif, report::sarif(run, allow));
  const bool is_read = std::ranges::any_of(
      run.files, [](const report::FileRun& file) { return file.errors.empty(); });
  if (!to_stdout && !outputs.quiet && is_read) {
    const bool colour = report::wants_colour(
        colour_of(outputs.colour), isatty(STDOUT_FILENO) != 0, std::getenv("NO_COLOR"));
    std::cout << report::terminal(
        run, colour, outputs.verbose ? report::Detail::full : report::Detail::brief);
  }
  if (!outputs.github) return;
  (to_stdout ? std::cerr : std::cout) << report::github_annotations(run, allow);
  if (const char* summary = std::getenv("GITHUB_STEP_SUMMARY"); summary && *summary)
    append(summary, report::github_summary(run));
}

}  // namespace seam::cli
