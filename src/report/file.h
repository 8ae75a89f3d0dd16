// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace seam::report {

/// What went wrong with a file, in a sentence; it becomes exit status 74.
struct FileError {
  std::string message;
};

/// Writes a file whole or not at all: whoever reads the path finds the old bytes or the new
/// ones. Makes the folders that are missing. Nothing is returned when all went well.
[[nodiscard]] std::optional<FileError> write_file(const std::filesystem::path&,
                                                  std::string_view bytes);

}  // namespace seam::report
