// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/file.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <fstream>
#include <system_error>

// The bytes go to a new file beside the old one, which then takes its name: on one
// file system a rename is a single step. A pipe or a device, such as /dev/full, keeps its name
// and is written to.

namespace seam::report {
namespace {

std::atomic<long> named_process = 0;

FileError cannot_write(const std::filesystem::path& path, const std::string& why) {
  return {"cannot write " + path.string() + ": " + why};
}

// Why it failed, empty where it did not.
std::error_code write_bytes(const std::filesystem::path& path, std::string_view bytes) {
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (file) return {};
  return {errno == 0 ? EIO : errno, std::generic_category()};
}

bool is_device(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  return !error && std::filesystem::exists(status) && !is_regular_file(status) &&
         !is_directory(status);
}

}  // namespace

void write_for(long process) {
  named_process = process;
}

FileSet::~FileSet() {
  std::error_code ignored;
  for (const auto& [unfinished, path] : files_) std::filesystem::remove(unfinished, ignored);
}

std::optional<FileError> FileSet::add(const std::filesystem::path& path,
                                      std::string_view bytes) {
  std::error_code error;
  if (path.has_parent_path()) std::filesystem::create_directories(path.parent_path(), error);
  if (error) return cannot_write(path, error.message());
  std::filesystem::path unfinished = path;
  unfinished +=
      ".unfinished-" + std::to_string(named_process > 0 ? named_process.load() : getpid());
  files_.emplace_back(unfinished, path);
  error = write_bytes(unfinished, bytes);
  if (error) return cannot_write(path, error.message());
  return std::nullopt;
}

std::optional<FileError> FileSet::put_in_place() {
  for (const auto& [unfinished, path] : files_) {
    std::error_code error;
    std::filesystem::rename(unfinished, path, error);
    if (error) return cannot_write(path, error.message());
  }
  files_.clear();
  return std::nullopt;
}

std::optional<FileError> write_file(const std::filesystem::path& path, std::string_view bytes) {
  if (is_device(path)) {
    const std::error_code error = write_bytes(path, bytes);
    return error ? std::optional(cannot_write(path, error.message())) : std::nullopt;
  }
  FileSet file;
  if (auto error = file.add(path, bytes)) return error;
  return file.put_in_place();
}

}  // namespace seam::report
