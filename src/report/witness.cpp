// SPDX-License-Identifier: GPL-3.0-or-later
#include "report/witness.h"

#include <regex>

namespace seam::report {
namespace {

constexpr std::size_t longest = 5000;  // bytes; beyond, nobody reads it: it stays as it is

}  // namespace

std::string readable_witness(const std::string& witness) {
  static const std::pair<std::regex, std::string> signs[] = {
      {std::regex(" != "), " ≠ "},
      {std::regex(" <= "), " ≤ "},
      {std::regex(" >= "), " ≥ "},
      {std::regex("sqrt\\((\\d+)\\)"), "√$1"},
      {std::regex("\\*"), "·"}};
  if (witness.size() > longest) return witness;
  std::string result = witness;
  for (const auto& [spelled, sign] : signs) result = std::regex_replace(result, spelled, sign);
  return result;
}

}  // namespace seam::report
