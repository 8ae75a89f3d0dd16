// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cctype>
#include <set>

#include "report/figure.h"

namespace seam::report {
namespace {

std::string slug(const std::string& title) {
  constexpr std::size_t longest = 60;
  std::string result;
  for (const unsigned char c : title) {
    if (result.size() >= longest) break;
    if (c < 0x80 && std::isalnum(c))
      result += static_cast<char>(std::tolower(c));
    else if (!result.empty() && result.back() != '-')
      result += '-';
  }
  while (!result.empty() && result.back() == '-') result.pop_back();
  return result.empty() ? "figure" : result;
}

// Ids hold letters of Greek by their names, digits, and `. _ - :`; a colon is no part of a file
// name everywhere. What came from elsewhere than a .seam file may hold anything.
std::string file_name(std::string id) {
  std::ranges::replace(id, ':', '=');
  const bool fine = std::ranges::all_of(id, [](unsigned char c) {
    return c < 0x80 && (std::isalnum(c) || c == '.' || c == '_' || c == '-' || c == '=');
  });
  return fine && !id.starts_with('.') ? id : slug(id);
}

}  // namespace

std::vector<NamedFigure> figures(const FileRun& file) {
  std::vector<NamedFigure> result;
  std::set<std::string> taken;
  for (const ItemRun& item : file.items) {
    const auto* figure = std::get_if<FigureRun>(&item);
    if (!figure) continue;
    const std::string name = figure->id.empty() ? slug(figure->title) : file_name(figure->id);
    std::string unique = name;
    for (int k = 2; !taken.insert(unique).second; ++k) unique = name + "-" + std::to_string(k);
    result.push_back({unique, figure});
  }
  return result;
}

}  // namespace seam::report
