// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/vocabulary.h"

#include <CLI/CLI.hpp>

namespace seam::cli {
namespace {

/// The parts of a text between separators.
std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

Word word(const CLI::Option& option) {
  Word word;
  word.help = option.get_description();
  word.preset = option.get_default_str();
  word.required = option.get_required();
  word.repeats = option.get_expected_max() > 1;
  if (option.nonpositional()) {
    for (const auto& name : option.get_snames()) word.names.push_back("-" + name);
    for (const auto& name : option.get_lnames()) word.names.push_back("--" + name);
  }
  // The type says `WHEN:{auto,always,never}` where only these are possible.
  const std::string type = option.get_type_name();
  const std::size_t colon = type.find(':');
  if (option.get_type_size() != 0)
    word.value = option.nonpositional() ? type.substr(0, colon) : option.get_name();
  if (const std::size_t open = type.find('{', colon); colon != type.npos && open != type.npos)
    word.choices = split(type.substr(open + 1, type.find('}') - open - 1), ',');
  return word;
}

Command command(const CLI::App& app) {
  Command command;
  command.help = app.get_description();
  for (const CLI::Option* option : app.get_options())
    if (!option->get_group().empty())
      (option->nonpositional() ? command.options : command.arguments).push_back(word(*option));
  return command;
}

}  // namespace

std::vector<Command> vocabulary(const CLI::App& app) {
  std::vector<Command> all{command(app)};
  for (const CLI::App* sub : app.get_subcommands(nullptr)) {
    all.push_back(command(*sub));
    all.back().name = sub->get_name();
  }
  return all;
}

}  // namespace seam::cli
