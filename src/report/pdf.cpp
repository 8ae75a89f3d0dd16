// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/pdf.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <vector>

// pdflatex runs until its notes to itself no longer change: page breaks of long tables
// settle after two or three runs. That they never settle is not known to happen, so the runs
// are counted.

namespace seam::report {
namespace {

namespace fs = std::filesystem;

constexpr int most_runs = 4;
constexpr int not_found = 127;

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

// A new folder that goes with the object.
class Workplace {
 public:
  Workplace() {
    std::string pattern = (fs::temp_directory_path() / "seamproof-XXXXXX").string();
    if (mkdtemp(pattern.data())) path_ = pattern;
  }
  ~Workplace() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

// The exit status of pdflatex on report.tex in the folder. TeX may neither read above the
// folder nor write outside it nor start a program.
int run_pdflatex(const fs::path& folder) {
  std::vector<std::string> words = {"pdflatex", "-no-shell-escape", "-interaction=nonstopmode",
                                    "-halt-on-error", "report.tex"};
  std::vector<std::string> settings = {"openin_any=p", "openout_any=p", "max_print_line=1000"};
  std::vector<char*> arguments, environment;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  for (char** variable = environ; *variable; ++variable) environment.push_back(*variable);
  for (std::string& setting : settings) environment.push_back(setting.data());
  environment.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&actions, 2, "/dev/null", O_WRONLY, 0);
  pid_t child = 0;
  const int failed = posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(),
                                  environment.data());
  posix_spawn_file_actions_destroy(&actions);
  int status = 0;
  if (failed || waitpid(child, &status, 0) != child) return not_found;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

// The first complaint in a log, with the line of input it is about.
std::string complaint(const fs::path& log) {
  std::ifstream file(log);
  std::string message;
  for (std::string line; std::getline(file, line);) {
    if (message.empty() && line.starts_with("!")) message = line.substr(1);
    if (!message.empty() && line.starts_with("l.")) return message + " at " + line;
  }
  return message.empty() ? " no reason given" : message;
}

}  // namespace

std::optional<FileError> typeset(const fs::path& tex) {
  fs::path pdf = tex;
  return typeset(bytes_of(tex), pdf.replace_extension(".pdf"));
}

std::optional<FileError> typeset(const std::string& document, const fs::path& pdf) {
  const auto failure = [&](const std::string& why) {
    return FileError{"cannot typeset " + pdf.string() + ": " + why};
  };
  const Workplace workplace;
  if (workplace.path().empty()) return failure("no temporary folder can be made");
  if (auto error = write_file(workplace.path() / "report.tex", document)) return error;

  const fs::path notes = workplace.path() / "report.aux";
  for (int run = 0; run < most_runs; ++run) {
    const std::string before = bytes_of(notes);
    const int status = run_pdflatex(workplace.path());
    if (status == not_found)
      return failure(
          "pdflatex is not installed (Debian: texlive-latex-recommended texlive-pictures "
          "lmodern)");
    if (status != 0) return failure("pdflatex:" + complaint(workplace.path() / "report.log"));
    if (run > 0 && bytes_of(notes) == before) break;
  }
  return write_file(pdf, bytes_of(workplace.path() / "report.pdf"));
}

}  // namespace seam::report
