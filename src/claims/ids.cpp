// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/ids.h"

#include <set>

#include "claims/greek.h"

namespace seam::claims {
namespace {

// What may stand in an id; everything else becomes a hyphen.
std::string slug(const std::string& label) {
  std::string result;
  for (const char c : spelled_out(label)) {
    const bool fine = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                      (c >= '0' && c <= '9') || c == '_' || c == '-';
    if (fine)
      result += c;
    else if (!result.empty() && result.back() != '-')
      result += '-';
  }
  while (!result.empty() && result.back() == '-') result.pop_back();
  return result;
}

std::string slug_or_number(const std::string& label, std::size_t place) {
  const std::string word = slug(label);
  return word.empty() ? std::to_string(place + 1) : word;
}

void collect(const File& file, const Opener& open, std::set<std::string>& included,
             std::vector<Named>& names) {
  for (const Item& item : file.items) {
    if (item.kind == Item::Kind::claim) names.push_back({item.name, item.claim.title});
    if (item.kind == Item::Kind::table)
      for (std::size_t row = 0; row < item.rows.size(); ++row)
        for (std::size_t column = 0; column < item.rows[row].printed.size(); ++column)
          names.push_back(cell(item, row, column));
    if (item.kind == Item::Kind::include && included.insert(item.name).second)
      if (const auto source = open(item.name))
        collect(parse(source).file, open, included, names);
  }
}

}  // namespace

Named cell(const Item& table, std::size_t row, std::size_t column) {
  const std::string& row_label = table.rows[row].label;
  const bool has_label = column < table.labels.size();
  const std::string column_label = has_label ? table.labels[column] : "";
  return {table.name + "." + slug_or_number(row_label, row) + "." +
              slug_or_number(column_label, column),
          row_label + (has_label ? ", " + column_label : "")};
}

std::vector<Named> named_claims(const File& file, const Opener& open) {
  std::vector<Named> names;
  std::set<std::string> included;
  collect(file, open, included, names);
  return names;
}

}  // namespace seam::claims
