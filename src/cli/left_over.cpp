// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/left_over.h"

#include <fstream>
#include <string>
#include <vector>

// A file that is no certificate was not written by the program, and stays. So does what another
// run is about to finish.

namespace seam::cli {
namespace fs = std::filesystem;
namespace {

// Whether a process is at work. One that was killed may stay in the list of processes for a
// while, as a zombie (Z).
bool is_at_work(const std::string& process) {
  std::ifstream file("/proc/" + process + "/stat");
  std::string stat;
  if (!std::getline(file, stat)) return false;
  const std::size_t name_end = stat.rfind(") ");  // the name may hold anything
  return name_end == std::string::npos || stat.compare(name_end + 2, 1, "Z") != 0;
}

// The process that wrote it, by the end of its name, is no more.
bool is_unfinished(const fs::path& file) {
  static const std::string mark = ".unfinished-";
  const std::string name = file.filename().string();
  const std::size_t at = name.rfind(mark);
  if (at == std::string::npos) return false;
  const std::string process = name.substr(at + mark.size());
  return !process.empty() && process.find_first_not_of("0123456789") == std::string::npos &&
         !is_at_work(process);
}

bool is_certificate(const fs::path& file) {
  static const std::string start = "{\n \"format\": \"seamproof certificate ";
  std::string bytes(start.size(), '\0');
  std::ifstream(file, std::ios::binary).read(bytes.data(), std::ssize(bytes));
  return bytes == start;
}

void remove_all(const std::vector<fs::path>& files) {
  std::error_code ignored;
  for (const fs::path& file : files) fs::remove(file, ignored);
}

}  // namespace

void remove_unfinished(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> found;
  for (const auto& entry : fs::recursive_directory_iterator(folder, error))
    if (entry.is_regular_file(error) && is_unfinished(entry.path()))
      found.push_back(entry.path());
  remove_all(found);
}

void remove_vanished(const fs::path& folder, const Verified& verified) {
  if (verified.extent == Verified::Extent::selection) return;
  std::error_code error;
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(folder / "certificates", error))
    if (entry.is_regular_file(error) &&
        !verified.certificates.contains("certificates/" + entry.path().filename().string()) &&
        is_certificate(entry.path()))
      found.push_back(entry.path());
  remove_all(found);
}

void remove_outdated(const fs::path& folder, const std::set<std::string>& written) {
  std::error_code error;
  std::vector<fs::path> found;
  const auto look_at = [&](const fs::path& file) {
    if (!written.contains(file.lexically_relative(folder).generic_string()))
      found.push_back(file);
  };
  for (const char* name : {"report.html", "report.pdf"}) look_at(folder / name);
  for (const char* part : {"fragments", "figures"})
    for (const auto& entry : fs::recursive_directory_iterator(folder / part, error)) {
      const std::string kind = entry.path().extension().string();
      for (const char* ours : {".tex", ".sty", ".svg", ".glb", ".pdf"})
        if (kind == ours && entry.is_regular_file(error)) look_at(entry.path());
    }
  remove_all(found);
}

}  // namespace seam::cli
