// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "cli/vocabulary.h"

namespace seam::cli {

/// What may stand at the end of a command line: words, each with a remark, or files, which
/// shells know better.
struct Completion {
  struct Candidate {
    std::string word, remark;
  };
  std::vector<Candidate> words;
  std::string files;  ///< `/*.seam`, `/*`, or `/` for folders alone; empty: none
};

/// `before` are the words after `seamproof` that are complete, `last` is the beginning of the
/// next one. Claim ids are read from the .seam files named before; where one cannot be read,
/// there are none.
Completion completion(const std::vector<Command>&, const std::vector<std::string>& before,
                      const std::string& last);

/// `seamproof complete WORD...`: prints what may stand in the place of the last word. A line is
/// a word, then perhaps a tab and a remark; where files may stand, a line `files` and their
/// pattern. Returns the exit status.
int complete(const std::vector<Command>&, std::vector<std::string> words);

}  // namespace seam::cli
