// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/file.h"

#include <unistd.h>

#include <fstream>
#include <system_error>

// The bytes go to a new file beside the old one, which then takes its name: on one
// file system a rename is a single step.

namespace seam::report {
namespace {

FileError cannot_write(const std::filesystem::path& path, const std::string& why) {
  return {"cannot write " + path.string() + ": " + why};
}

}  // namespace

std::optional<FileError> write_file(const std::filesystem::path& path, std::string_view bytes) {
  std::error_code error;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
  if (error) return cannot_write(path, error.message());

  std::filesystem::path unfinished = path;
  unfinished += ".unfinished-" + std::to_string(getpid());
  std::ofstream file(unfinished, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (file) {
    std::filesystem::rename(unfinished, path, error);
    if (!error) return std::nullopt;
  } else {
    error = std::error_code(errno, std::generic_category());
  }
  std::error_code ignored;
  std::filesystem::remove(unfinished, ignored);
  return cannot_write(path, error.message());
}

}  // namespace seam::report
