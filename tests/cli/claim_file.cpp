// SPDX-License-Identifier: GPL-3.0-or-later
// claim_file PROGRAM FILE.seam
//
// Runs the program on a file that says in comments what must come of it:
//
//   # command: format              what to run; without it: verify
//   # expect: exit 1               the exit status; without it: 0
//   # verdict: ID VERDICT TEXT     a line of the output holds the three, in this order; TEXT
//   may be missing # message: TEXT                the output holds the text
//
// Every message and verdict must be met. A file that says nothing of them fails: a test that
// looks at nothing tests nothing.

#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "process.h"

namespace {

struct Expected {
  std::string command = "verify";
  int status = 0;
  std::vector<std::string> verdicts, messages;
};

Expected read(std::istream& file) {
  Expected expected;
  const auto after = [](const std::string& line, const std::string& start) {
    return line.starts_with(start) ? line.substr(start.size()) : std::string();
  };
  for (std::string line; std::getline(file, line);) {
    if (auto text = after(line, "# command: "); !text.empty()) expected.command = text;
    if (auto text = after(line, "# expect: exit "); !text.empty())
      expected.status = std::stoi(text);
    if (auto text = after(line, "# verdict: "); !text.empty())
      expected.verdicts.push_back(text);
    if (auto text = after(line, "# message: "); !text.empty())
      expected.messages.push_back(text);
  }
  return expected;
}

// A terminal line reads `shape verdict id text`.
bool shows(const std::string& line, const std::string& id, const std::string& verdict,
           const std::string& text) {
  std::istringstream words(line);
  std::string shape, shown_verdict, shown_id, rest;
  words >> shape >> shown_verdict >> shown_id;
  std::getline(words, rest);
  return shown_verdict == verdict && shown_id == id && rest.find(text) != std::string::npos;
}

bool met(const std::string& expectation, const std::string& output) {
  std::istringstream words(expectation);
  std::string id, verdict, text;
  words >> id >> verdict >> std::ws;
  std::getline(words, text);
  std::istringstream lines(output);
  for (std::string line; std::getline(lines, line);)
    if (shows(line, id, verdict, text)) return true;
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 64;
  std::ifstream file(argv[2]);
  const Expected expected = read(file);
  const auto finished = seam::test::run(seam::test::quoted(argv[1]) + " " + expected.command +
                                        " " + seam::test::quoted(argv[2]));

  std::vector<std::string> failures;
  if (finished.status != expected.status)
    failures.push_back("exit " + std::to_string(finished.status) + ", not " +
                       std::to_string(expected.status));
  for (const std::string& verdict : expected.verdicts)
    if (!met(verdict, finished.output)) failures.push_back("no line says: " + verdict);
  for (const std::string& message : expected.messages)
    if (finished.output.find(message) == std::string::npos)
      failures.push_back("nothing says: " + message);
  if (expected.verdicts.empty() && expected.messages.empty())
    failures.emplace_back("the file says nothing of its verdicts or messages");

  for (const std::string& failure : failures) std::cerr << failure << '\n';
  if (!failures.empty()) std::cerr << "--- output\n" << finished.output;
  return failures.empty() ? 0 : 1;
}
