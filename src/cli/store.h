// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "certificate/evidence.h"

namespace seam::cli {

/// Evidence of earlier runs, by what it is about: the statement, the build of the program and
/// the effort. It holds no verdicts: whoever takes evidence from it has it judged.
///
/// An entry is there whole or not at all. One that is damaged, or about something else, is
/// none. A folder that cannot be written keeps nothing, which is no error.
class Store {
 public:
  /// `folder` may be empty: that store has no entries and keeps none.
  Store(const std::string& folder, long effort);

  std::optional<certificate::Evidence> find(const certificate::Statement&) const;

  /// Whether it was kept. `certificate` is the text of one, about the statement.
  bool keep(const certificate::Statement&, const std::string& certificate) const;

  /// $XDG_CACHE_HOME/seamproof, or ~/.cache/seamproof; empty where there is neither.
  static std::string usual_folder();

 private:
  std::filesystem::path entry(const certificate::Statement&) const;

  std::filesystem::path folder_;  ///< of this build and effort; empty: none
};

}  // namespace seam::cli
