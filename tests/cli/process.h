// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/wait.h>

#include <cstdio>
#include <string>

namespace seam::test {

/// What a finished program left.
struct Finished {
  int status = -1;     ///< its exit status; 128 + the signal if one ended it
  std::string output;  ///< stdout and stderr, as they came
};

inline std::string quoted(const std::string& word) {
  std::string result = "'";
  for (const char c : word) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

/// Runs a line of shell.
inline Finished run(const std::string& line) {
  Finished finished;
  FILE* pipe = popen(("{ " + line + "\n} 2>&1").c_str(), "r");
  if (!pipe) return finished;
  char buffer[4096];
  while (const std::size_t n = fread(buffer, 1, sizeof buffer, pipe))
    finished.output.append(buffer, n);
  const int status = pclose(pipe);
  finished.status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return finished;
}

}  // namespace seam::test
