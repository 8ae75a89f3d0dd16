// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <iostream>

#include "cli/command_line.h"
#include "cli/completion.h"
#include "cli/files.h"
#include "cli/manual.h"
#include "cli/supervisor.h"
#include "text/standard_streams.h"

using namespace seam::cli;

namespace {

int run(int argc, char** argv) {
  Arguments arguments;
  const auto app = command_line(arguments);
  // Asked by the shells' completion, where what is typed may be wrong in any way.
  if (argc > 2 && std::string_view(argv[1]) == "complete")
    return complete(vocabulary(*app), {argv + 2, argv + argc});
  if (argc == 2 && std::string_view(argv[1]) == "manual") {
    std::cout << manual(vocabulary(*app));
    return ok;
  }
  try {
    app->parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    const int status = app->exit(error);
    return status == 0 ? ok : usage;
  }
  const Outputs& outputs = arguments.outputs;
  for (const auto& [option, is_wanted] : {std::pair("--pdf", outputs.pdf),
                                          {"--html", outputs.html},
                                          {"--fragments", outputs.fragments}})
    if (is_wanted && outputs.out.empty())
      throw Failure{usage, std::string(option) + " needs --out\n"};
  if ((outputs.json == "-") + (outputs.junit == "-") + (outputs.sarif == "-") > 1)
    throw Failure{usage, "only one of --json, --junit and --sarif can go to standard output\n"};
  return arguments.command();
}

}  // namespace

int main(int argc, char** argv) {
  seam::text::hold_standard_streams();
  try {
    return supervised([&] {
      const int status = run(argc, argv);
      const std::string failure = seam::text::end_of_output();
      if (!failure.empty()) throw Failure{io_error, failure};
      return status;
    });
  } catch (const Failure& failure) {
    std::cerr << failure.message;
    return failure.status;
  } catch (const std::exception& error) {
    std::cerr << "internal error: " << error.what() << "\n";
    return internal;
  }
}
