// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "cli/mutate.h"
#include "cli/outputs.h"
#include "cli/verify.h"

namespace CLI {
class App;
}

namespace seam::cli {

/// What was written after `seamproof`: the values of options and arguments, and what the
/// command does with them.
struct Arguments {
  std::vector<std::string> files;
  std::string file, id, expression, name, paper;
  VerifyOptions search;
  Outputs outputs;
  MutateOptions mutation;
  VerifyOptions trials;  ///< of mutants: each may take less
  int digits = 30;
  bool in_place = false;
  bool for_coq = false;

  std::function<int()> command;  ///< set by parsing; what it returns is the exit status
};

/// The commands of `seamproof` with their options and help. Parsing fills the arguments, which
/// have to live as long as the result.
std::unique_ptr<CLI::App> command_line(Arguments&);

}  // namespace seam::cli
