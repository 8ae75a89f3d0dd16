// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/files.h"

#include <algorithm>
#include <fstream>
#include <sstream>

namespace seam::cli {
namespace fs = std::filesystem;
namespace {

constexpr std::uintmax_t largest_file = 64u << 20;

std::optional<std::string> bytes_of(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error) || fs::file_size(path, error) > largest_file)
    return std::nullopt;
  std::ifstream in(path, std::ios::binary);
  if (!in) return std::nullopt;
  std::ostringstream all;
  all << in.rdbuf();
  return std::move(all).str();
}

std::string rendered(const std::vector<text::Diagnostic>& errors) {
  constexpr std::size_t most = 50;
  std::string all;
  for (std::size_t i = 0; i < errors.size() && i < most; ++i) all += text::render(errors[i]);
  if (errors.size() > most) all += std::to_string(errors.size() - most) + " more errors\n";
  return all;
}

}  // namespace

std::shared_ptr<const text::Source> open(const fs::path& path) {
  auto bytes = bytes_of(path);
  if (!bytes) throw Failure{missing_input, "cannot read '" + path.string() + "'\n"};
  return std::make_shared<const text::Source>(text::Source{path.string(), std::move(*bytes)});
}

claims::Opener opener_beside(const fs::path& file) {
  const fs::path folder = fs::weakly_canonical(file).parent_path();
  return [folder](const std::string& name) -> std::shared_ptr<const text::Source> {
    std::error_code error;
    const fs::path path = fs::weakly_canonical(folder / name, error);
    const auto [end, rest] =
        std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
    if (error || end != folder.end()) return nullptr;
    auto bytes = bytes_of(path);
    if (!bytes) return nullptr;
    return std::make_shared<const text::Source>(text::Source{name, std::move(*bytes)});
  };
}

std::vector<fs::path> seam_files(const std::vector<std::string>& arguments) {
  std::vector<fs::path> files;
  for (const std::string& argument : arguments) {
    if (!fs::is_directory(argument)) {
      files.emplace_back(argument);
      continue;
    }
    std::vector<fs::path> inside;
    for (const auto& entry : fs::recursive_directory_iterator(argument))
      if (entry.is_regular_file() && entry.path().extension() == ".seam")
        inside.push_back(entry.path());
    if (inside.empty()) throw Failure{missing_input, "no .seam file in '" + argument + "'\n"};
    std::ranges::sort(inside);
    files.insert(files.end(), inside.begin(), inside.end());
  }
  return files;
}

claims::File parsed(const fs::path& path) {
  claims::Parsed result = claims::parse(open(path));
  if (!result.errors.empty()) throw Failure{bad_file, rendered(result.errors), result.errors};
  return std::move(result.file);
}

claims::Meaning meant(const fs::path& path, const claims::Limits& limits) {
  // What was read is given meaning although other parts are wrong, so that all errors are told
  // at once.
  claims::Parsed result = claims::parse(open(path));
  claims::Meaning meaning = claims::mean(result.file, opener_beside(path), limits);
  result.errors.insert(result.errors.end(), meaning.errors.begin(), meaning.errors.end());
  std::ranges::stable_sort(result.errors, [](const auto& a, const auto& b) {
    return a.where.begin < b.where.begin;
  });
  if (!result.errors.empty()) throw Failure{bad_file, rendered(result.errors), result.errors};
  return meaning;
}

}  // namespace seam::cli
