// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "text/source.h"

namespace seam::cli {

/// What a paper in LaTeX says of a claim or a value by a macro of seamproof.sty.
struct Mention {
  enum class Kind {
    value,         ///< `\spval{id}{argument}`
    status,        ///< `\spstatus{id}` or `\spstatus{id}{argument}`
    known_status,  ///< `\SeamStatus{id}{argument}`: what `\spstatus{id}` prints
  };
  Kind kind = Kind::value;
  std::string id, argument;  ///< without comments and outer blanks
  text::Span where;          ///< the macro with its arguments
};

/// A file that the paper inputs, and that is not at or below its folder.
struct Unread {
  text::Span where;
  std::string name;
};

struct Paper {
  std::vector<Mention> mentions;         ///< in the order in which TeX comes to them
  std::vector<text::Diagnostic> errors;  ///< mentions that cannot be read
  std::vector<Unread> unread;
};

/// Reads a paper with what it inputs and includes below its own folder, as TeX does: comments,
/// verbatim text, what stands between \iffalse and \fi and after \end{document} are skipped.
/// Macros are not expanded. Throws `Failure` (66) if the file cannot be read.
Paper read_paper(const std::filesystem::path&);

}  // namespace seam::cli
