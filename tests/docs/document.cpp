// SPDX-License-Identifier: GPL-3.0-or-later
// document FILE.md BIN PROJECT
//
// Does what a document says, in a fresh folder, and compares what comes of it with what the
// document shows:
//
//   ```seam NAME.seam     the block is written to that file
//   ```seam               the block is verified, and every claim must be as expected
//   ```console            a line `$ COMMAND` is run by the shell; the lines below it are what
//                         it prints. Times are not compared, a line `…` stands for any lines
//   ```LANGUAGE NAME      likewise a file, of any other language
//   <!-- seam             what stands before the next block of the language without being
//   -->                   shown: definitions that the text takes for granted
//   <!-- exit N -->       the exit status of the next block, which is 0 otherwise (of its last
//                         command; that of the others is not looked at)
//
// The folder holds the project's proofs/, reports/ and docs/, and the programs as
// build/release/bin and on the PATH.
// `./dev WORD` is not run: `./dev help` must know the word.

#include <filesystem>
#include <fstream>
#include <iostream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "cli/process.h"

namespace {

namespace fs = std::filesystem;

struct Block {
  int line = 0;
  std::string language, name, before, text;
  int status = 0;
};

std::vector<Block> blocks_of(std::istream& document) {
  std::vector<Block> blocks;
  std::string before;
  int status = 0, number = 0;
  std::smatch found;
  const std::regex exits("<!-- exit ([0-9]+) -->"), fence("```([a-z]*) ?(.*)");
  for (std::string line; std::getline(document, line);) {
    ++number;
    if (line == "<!-- seam") {
      while (std::getline(document, line) && ++number && line != "-->") before += line + "\n";
    } else if (std::regex_match(line, found, exits)) {
      status = std::stoi(found[1]);
    } else if (std::regex_match(line, found, fence)) {
      Block block{number, found[1], found[2], before, {}, status};
      while (std::getline(document, line) && ++number && line != "```")
        block.text += line + "\n";
      blocks.push_back(block);
      before.clear();
      status = 0;
    }
  }
  return blocks;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);)
    lines.push_back(std::regex_replace(line, std::regex("[0-9]+\\.[0-9]+ s\\b"), "0.00 s"));
  while (!lines.empty() && lines.back().empty()) lines.pop_back();
  return lines;
}

// Whether the lines from `at` on are those that are shown from `from` on.
bool like(const std::vector<std::string>& shown, std::size_t from,
          const std::vector<std::string>& printed, std::size_t at) {
  if (from == shown.size()) return at == printed.size();
  if (shown[from] == "…") {
    for (std::size_t next = at; next <= printed.size(); ++next)
      if (like(shown, from + 1, printed, next)) return true;
    return false;
  }
  return at < printed.size() && shown[from] == printed[at] &&
         like(shown, from + 1, printed, at + 1);
}

class Reader {
 public:
  Reader(std::string file, fs::path folder, std::string bin, std::string project)
      : file_(std::move(file)),
        folder_(std::move(folder)),
        bin_(std::move(bin)),
        project_(std::move(project)) {}

  void follow(const Block& block) {
    if (block.language == "console") return console(block);
    if (block.language == "seam" || !block.name.empty()) return write(block);
  }

  int followed = 0, failures = 0;

 private:
  void fail(const Block& block, const std::string& why) {
    ++failures;
    std::cerr << file_ << ":" << block.line << ": " << why << "\n";
  }

  seam::test::Finished run(const std::string& command) {
    return seam::test::run(
        "cd " + seam::test::quoted(folder_.string()) + " && PATH=" + seam::test::quoted(bin_) +
        ":$PATH LC_ALL=C.UTF-8 NO_COLOR=1 XDG_CACHE_HOME=$PWD/.cache\nexport PATH LC_ALL "
        "NO_COLOR XDG_CACHE_HOME\n" +
        command);
  }

  void write(const Block& block) {
    const bool has_name = !block.name.empty();
    const std::string name =
        has_name ? block.name : "block" + std::to_string(block.line) + ".seam";
    std::ofstream(folder_ / name) << block.before << block.text;
    ++followed;
    if (has_name) return;
    const auto finished = run("seamproof verify " + name);
    if (finished.status != block.status)
      fail(block, "exit status " + std::to_string(finished.status) + ":\n" + finished.output);
  }

  void console(const Block& block) {
    std::string command, shown;
    int status = 0;
    std::istringstream lines(block.text);
    const auto finish = [&] {
      if (!command.empty()) status = compare(block, command, shown);
      command.clear();
      shown.clear();
    };
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("$ ")) {
        finish();
        command = line.substr(2);
      } else if (command.ends_with("\\")) {
        command += "\n" + line;
      } else {
        shown += line + "\n";
      }
    }
    finish();
    if (status != block.status)
      fail(block,
           "exit status " + std::to_string(status) + ", not " + std::to_string(block.status));
  }

  int compare(const Block& block, const std::string& command, const std::string& shown) {
    ++followed;
    if (command.starts_with("./dev ")) {
      const std::string word = command.substr(0, command.find(' ', 6));
      const auto help = seam::test::run(seam::test::quoted(project_) + "/dev help");
      if (help.output.find(word) == std::string::npos) fail(block, word + " is not known");
      return 0;
    }
    const auto finished = run(command);
    if (!like(lines_of(shown), 0, lines_of(finished.output), 0))
      fail(block, "$ " + command + "\n--- the document says\n" + shown + "--- printed (exit " +
                      std::to_string(finished.status) + ")\n" + finished.output);
    return finished.status;
  }

  std::string file_;
  fs::path folder_;
  std::string bin_, project_;
};

}  // namespace

int main(int argc, char** argv) {
  if (argc != 4) return 64;
  const fs::path document = argv[1], project = argv[3];
  const fs::path folder = fs::current_path() / document.stem();
  fs::remove_all(folder);
  fs::create_directories(folder / "build/release");
  fs::create_directory_symlink(argv[2], folder / "build/release/bin");
  for (const char* name : {"proofs", "reports", "docs"})
    fs::create_directory_symlink(project / name, folder / name);

  std::ifstream text(document);
  Reader reader(document.filename().string(), folder, argv[2], project.string());
  for (const Block& block : blocks_of(text)) reader.follow(block);
  std::cout << reader.followed << " blocks and commands followed\n";
  // A document with nothing to follow is no test.
  return reader.failures == 0 && reader.followed > 0 ? 0 : 1;
}
