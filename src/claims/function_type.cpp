// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/function_type.h"

namespace seam::claims {
namespace {

constexpr std::string_view word = "function", before = "vector ", behind = " of ";

int number(const std::string& digits) {
  return digits.size() > 4 ? 0 : std::stoi(digits);
}

}  // namespace

std::optional<FunctionType> FunctionType::of(const std::string& type) {
  const std::size_t at = type.find(word);
  if (at == std::string::npos) return std::nullopt;
  FunctionType result;
  if (at > 0) result.components = number(type.substr(before.size(), at - 1 - before.size()));
  if (const std::size_t end = at + word.size(); end < type.size())
    result.arguments = number(type.substr(end + behind.size()));
  return result;
}

}  // namespace seam::claims
