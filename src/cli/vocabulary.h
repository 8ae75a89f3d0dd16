// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace seam::cli {

/// An option, or an argument by its place.
struct Word {
  std::vector<std::string> names;  ///< `-i`, `--in-place`; none: an argument
  std::string value;  ///< what follows or stands there: `FILE`, `DIR`; empty: a flag
  std::vector<std::string> choices;  ///< if only these are possible
  std::string help, preset;
  bool repeats = false, required = false;
};

/// A command, or with an empty name what stands before one.
struct Command {
  std::string name, help;
  std::vector<Word> options, arguments;
};

/// Everything that may be said on the command line, as plain data, for completion and manual:
/// first what stands before a command, then the commands in the order of the help.
std::vector<Command> vocabulary(const CLI::App&);

}  // namespace seam::cli
