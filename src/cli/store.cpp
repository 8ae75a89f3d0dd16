// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/store.h"

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "certificate/json.h"
#include "certificate/sha256.h"
#include "cli/build.h"
#include "report/file.h"

// An entry is the hash of its text, a line feed, and the text of a certificate. The hash finds
// damage by accident; against forgery there is the judge.

namespace seam::cli {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t hash_length = 64;

}  // namespace

Store::Store(const std::string& folder, long effort) {
  if (!folder.empty())
    folder_ = fs::path(folder) / (build_name() + "-" + std::to_string(effort));
}

fs::path Store::entry(const certificate::Statement& statement) const {
  const std::string digest = certificate::digest(statement);
  return folder_ / digest.substr(0, 2) / (digest + ".json");
}

std::optional<certificate::Evidence> Store::find(
    const certificate::Statement& statement) const {
  if (folder_.empty()) return std::nullopt;
  std::ifstream file(entry(statement), std::ios::binary);
  if (!file) return std::nullopt;
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (bytes.size() <= hash_length || bytes[hash_length] != '\n') return std::nullopt;
  const std::string_view text = std::string_view(bytes).substr(hash_length + 1);
  if (certificate::sha256(text) != bytes.substr(0, hash_length)) return std::nullopt;
  try {
    certificate::Certificate certificate = certificate::read(text);
    if (certificate.statement == statement) return std::move(certificate.evidence);
  } catch (const certificate::FormatError&) {
  }
  return std::nullopt;
}

bool Store::keep(const certificate::Statement& statement,
                 const std::string& certificate) const {
  if (folder_.empty()) return false;
  const std::string bytes = certificate::sha256(certificate) + "\n" + certificate;
  return !report::write_file(entry(statement), bytes);
}

std::string Store::usual_folder() {
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache == '/')
    return (fs::path(cache) / "seamproof").string();
  if (const char* home = std::getenv("HOME"); home && *home == '/')
    return (fs::path(home) / ".cache" / "seamproof").string();
  return {};
}

}  // namespace seam::cli
