// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/completion.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>

#include "claims/ids.h"
#include "cli/files.h"

// The words before the last are read as the program itself would read them: the first that is
// no option is the command, an option takes the next word if it takes a value, and what is left
// are arguments, of which the last may repeat.

namespace seam::cli {
namespace {

using Candidate = Completion::Candidate;

bool is_option(const std::string& word) {
  return word.starts_with("-") && word != "-";
}

const Word* find_option(const Command& command, const std::string& name) {
  for (const Word& option : command.options)
    if (std::ranges::find(option.names, name) != option.names.end()) return &option;
  return nullptr;
}

/// What was said before the last word.
struct Said {
  const Command* command = nullptr;
  const Word* awaits_value = nullptr;  ///< an option whose value comes next
  std::vector<std::string> options, arguments;
};

Said read(const std::vector<Command>& commands, const std::vector<std::string>& before) {
  Said said;
  said.command = &commands.front();
  for (const std::string& word : before) {
    if (said.awaits_value) {
      said.awaits_value = nullptr;
    } else if (is_option(word)) {
      said.options.push_back(word.substr(0, word.find('=')));
      const Word* option = find_option(*said.command, said.options.back());
      if (option && !option->value.empty() && word.find('=') == word.npos)
        said.awaits_value = option;
    } else if (said.command->name.empty()) {
      const auto named = std::ranges::find(commands, word, &Command::name);
      if (named != commands.end()) said.command = &*named;
    } else {
      said.arguments.push_back(word);
    }
  }
  return said;
}

std::vector<Candidate> ids(const std::vector<std::string>& files) {
  std::vector<Candidate> found;
  try {
    for (const auto& file : seam_files(files))
      for (const auto& [id, title] : claims::named_claims(parsed(file), opener_beside(file)))
        found.push_back({id, title});
  } catch (const Failure&) {
    return {};
  }
  return found;
}

Completion value(const Word& word, const Said& said) {
  Completion result;
  for (const std::string& choice : word.choices) result.words.push_back({choice, ""});
  if (!word.choices.empty()) return result;
  const bool is_argument = word.names.empty();
  if (word.value.starts_with("ID")) {
    result.words = ids(said.arguments);
  } else if (word.value == "DIR") {
    result.files = "/";
  } else if (const std::size_t dot = word.value.find('.'); dot != word.value.npos) {
    result.files = "/*" + word.value.substr(dot);
  } else if (word.value.find("FILE") != word.value.npos) {
    result.files = is_argument ? "/*.seam" : "/*";
  }
  return result;
}

Completion options(const Said& said) {
  Completion result;
  for (const Word& option : said.command->options) {
    const bool is_said = std::ranges::any_of(said.options, [&](const std::string& name) {
      return std::ranges::find(option.names, name) != option.names.end();
    });
    if (!is_said || option.repeats) result.words.push_back({option.names.back(), option.help});
  }
  return result;
}

}  // namespace

Completion completion(const std::vector<Command>& commands,
                      const std::vector<std::string>& before, const std::string& last) {
  const Said said = read(commands, before);
  Completion result;
  if (said.awaits_value) {
    result = value(*said.awaits_value, said);
  } else if (is_option(last) || last == "-") {
    result = options(said);
  } else if (said.command->name.empty()) {
    for (const Command& command : commands)
      if (!command.name.empty()) result.words.push_back({command.name, command.help});
  } else if (const auto& arguments = said.command->arguments; !arguments.empty()) {
    const std::size_t place = std::min(said.arguments.size(), arguments.size() - 1);
    if (place == said.arguments.size() || arguments[place].repeats)
      result = value(arguments[place], said);
  }
  std::erase_if(result.words, [&](const Candidate& c) { return !c.word.starts_with(last); });
  return result;
}

int complete(const std::vector<Command>& commands, std::vector<std::string> words) {
  const std::string last = std::move(words.back());
  words.pop_back();
  if (const char* home = std::getenv("HOME"))
    for (std::string& word : words)  // shells pass on what is typed
      if (word.starts_with("~/")) word.replace(0, 1, home);
  const Completion found = completion(commands, words, last);
  if (!found.files.empty()) std::cout << found.files << "\n";
  for (const auto& [word, remark] : found.words) std::cout << word << "\t" << remark << "\n";
  return ok;
}

}  // namespace seam::cli
