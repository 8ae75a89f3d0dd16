// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <iostream>
#include <thread>

#include "cli/commands.h"
#include "cli/files.h"

using namespace seam::cli;

namespace {

int run(int argc, char** argv) {
  CLI::App app(
      "Reads the mathematics of a paper and says of every claim: proven, refuted, conditional, "
      "undecided.",
      "seamproof");
  app.set_version_flag("--version", std::string("seamproof ") + SEAMPROOF_VERSION);
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);

  std::vector<std::string> files;
  std::string file, id, expression, name;
  VerifyOptions options;
  options.jobs = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  Outputs outputs;
  int digits = 30;
  bool in_place = false;

  const auto add_search = [&](CLI::App* command) {
    command->add_option("--timeout", options.timeout, "seconds a claim may take")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command->add_option("--effort", options.effort, "pieces a subdivision may have")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    command->add_option("--jobs", options.jobs, "claims at work at the same time")
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
  };

  CLI::App* verify = app.add_subcommand("verify", "decide every claim of the files");
  verify->add_option("file", files, ".seam files, or folders of them")->required();
  verify->add_option("--claim", options.claims,
                     "only claims with this id, or matching this glob");
  verify->add_option("--out", outputs.out,
                     "folder for report.tex, results.json and certificates/");
  verify->add_option("--json", outputs.json, "the results as JSON; - for standard output");
  verify->add_flag("--pdf", outputs.pdf, "typeset the report (needs --out and pdflatex)");
  verify->add_flag("--allow-undecided", outputs.allow_undecided,
                   "undecided claims are no failure");
  verify->add_flag("--quiet", outputs.quiet, "only the exit status");
  verify->add_option("--color", outputs.colour, "auto, always, never")
      ->check(CLI::IsMember({"auto", "always", "never"}));
  add_search(verify);

  CLI::App* report = app.add_subcommand("report", "verify, and write the report");
  report->add_option("file", files, ".seam files, or folders of them")->required();
  report->add_option("--out", outputs.out, "folder for the report")->required();
  report->add_flag("--pdf", outputs.pdf, "typeset it (needs pdflatex)");
  add_search(report);

  CLI::App* ask_command = app.add_subcommand("ask", "the certified value of an expression");
  ask_command->add_option("file", file, "a .seam file, for its definitions")->required();
  ask_command->add_option("expression", expression, "for example 'max(gauss(S))'")->required();
  ask_command->add_option("--digits", digits, "digits after the point")
      ->check(CLI::Range(0, 10000))
      ->capture_default_str();
  add_search(ask_command);

  CLI::App* explain_command =
      app.add_subcommand("explain", "what a claim was turned into and how it was decided");
  CLI::App* trust_command =
      app.add_subcommand("trust", "what has to be believed for a verdict");
  for (CLI::App* command : {explain_command, trust_command}) {
    command->add_option("file", file, "a .seam file")->required();
    command->add_option("id", id, "the id of a claim")->required();
    add_search(command);
  }

  CLI::App* list = app.add_subcommand("list", "the ids of all claims");
  list->add_option("file", files, ".seam files, or folders of them")->required();
  CLI::App* obligations = app.add_subcommand(
      "obligations", "digests of what every claim says, to compare with seamproof-check");
  obligations->add_option("file", files, ".seam files, or folders of them")->required();
  CLI::App* format = app.add_subcommand("format", "canonical layout, on standard output");
  format->add_option("file", files, ".seam files, or folders of them")->required();
  format->add_flag("-i,--in-place", in_place, "write the files instead");
  CLI::App* start = app.add_subcommand("new", "a commented starter file that verifies");
  start->add_option("name", name, "NAME.seam is written")->required();

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int status = app.exit(error);
    return status == 0 ? 0 : usage;
  }
  if (outputs.pdf && outputs.out.empty()) throw Failure{usage, "--pdf needs --out\n"};

  if (*verify) return verify_files(files, options, outputs);
  if (*report) return verify_files(files, options, outputs);
  if (*ask_command) return ask(file, expression, digits, options);
  if (*explain_command) return explain(file, id, options);
  if (*trust_command) return trust(file, id, options);
  if (*list) return list_claims(files);
  if (*obligations) return list_obligations(files);
  if (*format) return format_files(files, in_place);
  return start_file(name);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(argc, argv);
  } catch (const Failure& failure) {
    std::cerr << failure.message;
    return failure.status;
  } catch (const std::exception& error) {
    std::cerr << "internal error: " << error.what() << "\n";
    return internal;
  }
}
