// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <thread>

#include "cli/commands.h"
#include "cli/files.h"
#include "cli/store.h"

// One function a command. Help, man page and completion are made of what is said here; by its
// name, or that of its type, a value is completed: FILE, FOLDER, DIR, ID, ID-OR-GLOB.

namespace seam::cli {
namespace {

/// A command with its one line of help; `action` is done after parsing.
CLI::App* add_command(CLI::App& app, Arguments& to, const char* name, const char* help,
                      std::function<int()> action) {
  CLI::App* command = app.add_subcommand(name, help);
  command->callback([&to, action = std::move(action)] { to.command = action; });
  return command;
}

void add_files(CLI::App* command, Arguments& to) {
  command->add_option("FILE|FOLDER", to.files, ".seam files, or folders of them")
      ->type_name("")
      ->required();
}

void add_file(CLI::App* command, Arguments& to, const char* help) {
  command->add_option("FILE", to.file, help)->type_name("")->required();
}

CLI::Validator above_zero() {
  return {[](const std::string& text) {
            double number = 0;
            return CLI::detail::lexical_cast(text, number) && number > 0
                       ? std::string()
                       : "'" + text + "' is no number above 0";
          },
          ""};
}

/// How long, how far and how broadly is searched.
void add_search(CLI::App* command, VerifyOptions& to) {
  command
      ->add_option(
          "--timeout", to.timeout,
          "seconds that each step of a claim may take: reading it, the search, judging")
      ->type_name("S")
      ->check(above_zero())
      ->capture_default_str();
  command->add_option("--memory", to.memory, "MiB that each of these steps may take")
      ->type_name("MIB")
      ->check(above_zero());
  command->add_option("--effort", to.effort, "pieces a subdivision may have")
      ->type_name("N")
      ->check(above_zero())
      ->capture_default_str();
  to.jobs = std::clamp(static_cast<int>(std::thread::hardware_concurrency()), 1, 256);
  command
      ->add_option("--jobs", to.jobs, "claims at work at the same time; else one a processor")
      ->type_name("N")
      ->check(CLI::Range(1, 256).description(""));
  to.store = Store::usual_folder();
  CLI::Option* store =
      command
          ->add_option("--cache", to.store,
                       "where evidence is kept for the next run; else ~/.cache/seamproof")
          ->type_name("DIR");
  command
      ->add_flag_callback(
          "--no-cache", [&to] { to.store.clear(); }, "search for everything, keep nothing")
      ->excludes(store);
}

void add_claims(CLI::App* command, Arguments& to) {
  command
      ->add_option("--claim", to.search.claims,
                   "only claims with this id, or matching this glob")
      ->type_name("ID-OR-GLOB")
      ->allow_extra_args(false);
}

void add_verify(CLI::App& app, Arguments& to) {
  CLI::App* command = add_command(app, to, "verify", "decide every claim of the files", [&to] {
    return verify_files(to.files, to.search, to.outputs);
  });
  add_files(command, to);
  add_claims(command, to);
  command
      ->add_option("--out", to.outputs.out,
                   "folder for report.tex, results.json and certificates/")
      ->type_name("DIR");
  command->add_option("--json", to.outputs.json, "the results as JSON; - for standard output")
      ->type_name("FILE");
  command->add_option("--junit", to.outputs.junit, "the results as JUnit XML")
      ->type_name("FILE");
  command->add_option("--sarif", to.outputs.sarif, "what is not as expected, as SARIF 2.1.0")
      ->type_name("FILE");
  command->add_flag("--github", to.outputs.github,
                    "workflow commands and a summary for GitHub Actions");
  command->add_flag("--pdf", to.outputs.pdf, "typeset the report (needs --out and pdflatex)");
  command->add_flag("--html", to.outputs.html, "the report as a page, too (needs --out)");
  command->add_flag("--fragments", to.outputs.fragments,
                    "parts of the report for a paper to input, with their style (needs --out)");
  command->add_flag("--allow-undecided", to.outputs.allow_undecided,
                    "undecided claims are no failure");
  CLI::Option* quiet = command->add_flag("--quiet", to.outputs.quiet, "only the exit status");
  command
      ->add_flag("-v,--verbose", to.outputs.verbose,
                 "of each claim also how it was decided, and whether anew")
      ->excludes(quiet);
  command->add_option("--color", to.outputs.colour, "colours on standard output")
      ->type_name("WHEN")
      ->check(CLI::IsMember({"auto", "always", "never"}));
  add_search(command, to.search);
}

void add_report(CLI::App& app, Arguments& to) {
  CLI::App* command =
      add_command(app, to, "report", "the report of results, or of files",
                  [&to] { return report_files(to.files, to.search, to.outputs); });
  command
      ->add_option("DIR|FILE", to.files,
                   "folders that verify --out wrote, or .seam files and folders of them")
      ->type_name("")
      ->required();
  command->add_option("--out", to.outputs.out, "folder for the report")
      ->type_name("DIR")
      ->required();
  command->add_flag("--pdf", to.outputs.pdf, "typeset it (needs pdflatex)");
  command->add_flag("--html", to.outputs.html, "as a page, too");
  command->add_flag("--fragments", to.outputs.fragments,
                    "parts of it for a paper to input, with their style");
  add_search(command, to.search);
}

void add_export(CLI::App& app, Arguments& to) {
  CLI::App* command =
      add_command(app, to, "export", "certificates as theorems for a proof assistant",
                  [&to] { return export_coq(to.file, to.outputs.out, to.search); });
  command->add_option("DIR|FILE", to.file, "a folder that verify --out wrote, or a .seam file")
      ->type_name("")
      ->required();
  command->add_flag("--coq", to.for_coq, "for Coq, whose coqc proves them again")->required();
  command->add_option("--out", to.outputs.out, "folder for the files")
      ->type_name("DIR")
      ->required();
  add_claims(command, to);
  add_search(command, to.search);
}

void add_ask(CLI::App& app, Arguments& to) {
  CLI::App* command =
      add_command(app, to, "ask", "the certified value of an expression",
                  [&to] { return ask(to.file, to.expression, to.digits, to.search); });
  add_file(command, to, "a .seam file, for its definitions");
  command->add_option("EXPR", to.expression, "for example 'max(gauss(S))'")
      ->type_name("")
      ->required();
  command->add_option("--digits", to.digits, "digits after the point")
      ->type_name("N")
      ->check(CLI::Range(0, 10000).description(""))
      ->capture_default_str();
  add_search(command, to.search);
}

/// A command on one claim.
void add_claim_command(CLI::App& app, Arguments& to, const char* name, const char* help,
                       int (*action)(const std::string&, const std::string&,
                                     const VerifyOptions&)) {
  CLI::App* command = add_command(app, to, name, help,
                                  [&to, action] { return action(to.file, to.id, to.search); });
  add_file(command, to, "a .seam file");
  command->add_option("ID", to.id, "the id of a claim")->type_name("")->required();
  add_search(command, to.search);
}

void add_check_tex(CLI::App& app, Arguments& to) {
  CLI::App* command = add_command(app, to, "check-tex",
                                  "every \\spval and \\spstatus of a paper is printed right",
                                  [&to] { return check_tex(to.paper, to.files, to.search); });
  command->add_option("PAPER.tex", to.paper, "the paper, with what it inputs")
      ->type_name("")
      ->required();
  add_files(command, to);
  add_search(command, to.search);
}

void add_format(CLI::App& app, Arguments& to) {
  CLI::App* command = add_command(app, to, "format", "canonical layout, on standard output",
                                  [&to] { return format_files(to.files, to.in_place); });
  add_files(command, to);
  command->add_flag("-i,--in-place", to.in_place, "write the files instead");
}

void add_mutate(CLI::App& app, Arguments& to) {
  CLI::App* command =
      add_command(app, to, "mutate", "how much each claim notices of small changes",
                  [&to] { return mutate_file(to.file, to.mutation, to.trials, to.outputs); });
  add_file(command, to, "a .seam file");
  command
      ->add_option("--claim", to.trials.claims,
                   "only claims with this id, or matching this glob")
      ->type_name("ID-OR-GLOB")
      ->allow_extra_args(false);
  command->add_option("--seed", to.mutation.seed, "another seed draws other changes")
      ->type_name("N")
      ->capture_default_str();
  CLI::Option* count =
      command->add_option("--count", to.mutation.count, "changes of all claims together")
          ->type_name("N")
          ->check(CLI::Range(1, 1'000'000).description(""))
          ->capture_default_str();
  command->add_option("--per-claim", to.mutation.per_claim, "changes of each claim")
      ->type_name("N")
      ->check(CLI::Range(1, 100'000).description(""))
      ->excludes(count);
  command->add_option("--json", to.outputs.json, "the results as JSON; - for standard output")
      ->type_name("FILE");
  command
      ->add_option("--out", to.outputs.out,
                   "folder for the changed files that were decided, with certificates")
      ->type_name("DIR");
  command->add_flag("--quiet", to.outputs.quiet, "only the exit status");
  to.trials.timeout = 10;
  to.trials.memory = 2048;
  add_search(command, to.trials);
}

void add_new(CLI::App& app, Arguments& to) {
  CLI::App* command = add_command(app, to, "new", "a commented starter file that verifies",
                                  [&to] { return start_file(to.name); });
  command->add_option("NAME", to.name, "NAME.seam is written")->type_name("")->required();
}

}  // namespace

std::unique_ptr<CLI::App> command_line(Arguments& to) {
  auto app = std::make_unique<CLI::App>(
      "Reads the mathematics of a paper and says of every claim: proven, refuted, conditional, "
      "undecided.",
      "seamproof");
  app->set_help_flag("-h,--help", "how it is used");
  app->set_version_flag("--version", tool_name(), "which version this is");
  app->require_subcommand(1);
  app->get_formatter()->column_width(34);

  add_verify(*app, to);
  add_report(*app, to);
  add_export(*app, to);
  add_ask(*app, to);
  add_claim_command(*app, to, "explain", "what a claim was turned into and how it was decided",
                    explain);
  add_claim_command(*app, to, "trust", "what has to be believed for a verdict", trust);
  add_files(add_command(*app, to, "list", "the ids of all claims",
                        [&to] { return list_claims(to.files); }),
            to);
  add_files(add_command(*app, to, "obligations",
                        "digests of what every claim says, to compare with seamproof-check",
                        [&to] { return list_obligations(to.files); }),
            to);
  add_check_tex(*app, to);
  add_mutate(*app, to);
  add_format(*app, to);
  add_new(*app, to);
  return app;
}

}  // namespace seam::cli
