// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace seam::report {

/// What went wrong with a file, in a sentence; it becomes exit status 74.
struct FileError {
  std::string message;
};

/// Writes a file whole or not at all: whoever reads the path finds the old bytes or the new
/// ones; a pipe or a device is written to. Makes the folders that are missing. Nothing is
/// returned when all went well.
[[nodiscard]] std::optional<FileError> write_file(const std::filesystem::path&,
                                                  std::string_view bytes);

/// Files of one folder. All are written beside the places where they belong, before the first
/// takes its place: where there is no room for one, what was there is as it was.
class FileSet {
 public:
  FileSet() = default;
  ~FileSet();  ///< removes what was not put in place
  FileSet(const FileSet&) = delete;
  FileSet& operator=(const FileSet&) = delete;

  [[nodiscard]] std::optional<FileError> add(const std::filesystem::path&,
                                             std::string_view bytes);
  [[nodiscard]] std::optional<FileError> put_in_place();

 private:
  std::vector<std::pair<std::filesystem::path, std::filesystem::path>> files_;
};

/// From now on unfinished files are named for this process instead of the one that writes them:
/// one that does not outlive it. Whether they are still wanted is whether it is there.
void write_for(long process);

}  // namespace seam::report
