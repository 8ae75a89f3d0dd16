// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/manual.h"

#include <cctype>

#include "embedded/manual_page.h"

namespace seam::cli {
namespace {

/// Text of a manual page that means itself.
std::string escaped(const std::string& text) {
  std::string result = text.starts_with(".") || text.starts_with("'") ? "\\&" : "";
  for (const char c : text) {
    if (c == '\\')
      result += "\\e";
    else if (c == '-')
      result += "\\-";
    else
      result += c;
  }
  return result;
}

std::string sentence(std::string text) {
  text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return escaped(text) + ".\n";
}

std::string value_of(const Word& word) {
  std::string value;
  for (const std::string& choice : word.choices) value += (value.empty() ? "" : "|") + choice;
  return escaped(value.empty() ? word.value : value);
}

/// `Fl i , Fl -in-place`, `Fl -out Ar DIR`
std::string option(const Word& word) {
  std::string result;
  for (const std::string& name : word.names)
    result += (result.empty() ? "Fl " : " , Fl ") + escaped(name.substr(1));
  return word.value.empty() ? result : result + " Ar " + value_of(word);
}

std::string argument(const Word& word) {
  const std::string name = "Ar " + value_of(word) + (word.repeats ? " ..." : "");
  return word.required ? name : "Op " + name;
}

std::string list(const std::vector<Word>& words, std::string (*form)(const Word&)) {
  std::string result;
  for (const Word& word : words) {
    result += ".It " + form(word) + "\n" + escaped(word.help);
    if (!word.preset.empty()) result += " (default: " + escaped(word.preset) + ")";
    if (word.repeats && !word.names.empty()) result += "; may be repeated";
    result += "\n";
  }
  return result;
}

// Every command has --help; once is enough.
std::string section(Command command) {
  std::erase_if(command.options,
                [](const Word& word) { return word.names.back() == "--help"; });
  std::string result = ".Ss seamproof " + command.name + "\n.Bd -ragged\n.Nm Cm " +
                       command.name + " Op Ar option ...\n";
  for (const Word& word : command.arguments) result += "." + argument(word) + "\n";
  return result + ".Ed\n.Pp\n" + sentence(command.help) + ".Bl -tag -width 4n\n" +
         list(command.arguments, argument) + list(command.options, option) + ".El\n";
}

std::string all(const std::vector<Command>& commands) {
  std::string result =
      ".Bl -tag -width 4n\n" + list(commands.front().options, option) + ".El\n";
  for (const Command& command : commands)
    if (!command.name.empty()) result += section(command);
  return result;
}

}  // namespace

std::string manual(const std::vector<Command>& commands) {
  std::string page(embedded::manual_page);
  constexpr std::string_view place = ".\\\" COMMANDS\n";
  return page.replace(page.find(place), place.size(), all(commands));
}

}  // namespace seam::cli
