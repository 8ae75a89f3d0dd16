// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/excerpt.h"

#include <set>
#include <utility>

#include "claims/ids.h"
#include "claims/rests_on.h"

namespace seam::claims {
namespace {

using Kind = Item::Kind;

bool defines(const Item& item) {
  return item.kind == Kind::let || item.kind == Kind::sequence || item.kind == Kind::param ||
         item.kind == Kind::root || item.kind == Kind::define;
}

template <typename Part, typename SomeItem>
std::vector<Part*> parts(SomeItem& item) {
  std::vector<Part*> result;
  for (auto& e : item.expressions) result.push_back(&e);
  if (item.where) result.push_back(&*item.where);
  if (item.kind == Kind::claim) {
    result.push_back(&item.claim.statement);
    if (item.claim.corrected) result.push_back(&*item.claim.corrected);
  }
  for (auto& column : item.columns) result.push_back(&column);
  for (auto& row : item.rows) {
    result.push_back(&row.value);
    for (auto& printed : row.printed) result.push_back(&printed);
    for (auto& [cell, right] : row.corrected) result.push_back(&right);
  }
  return result;
}

File with_definitions(const File& file, Item about) {
  std::vector<const Item*> definitions;
  for (const Item& item : file.items)
    if (defines(item)) definitions.push_back(&item);
  File result{file.source, {}, {}};
  for (const Item* item : rests_on(definitions, expressions_of(std::as_const(about))))
    result.items.push_back(*item);
  result.items.push_back(std::move(about));
  for (Item& item : result.items) item.comments.clear();
  return result;
}

// Each file is included once, so this ends.
void collect(const File& file, const Opener& open, std::set<std::string>& included,
             std::vector<Item>& items) {
  for (const Item& item : file.items) {
    if (item.kind != Kind::include) {
      items.push_back(item);
    } else if (included.insert(item.name).second) {
      if (const auto source = open(item.name))
        collect(parse(source).file, open, included, items);
    }
  }
}

}  // namespace

File with_included(const File& file, const Opener& open) {
  File result{file.source, {}, {}};
  std::set<std::string> included;
  collect(file, open, included, result.items);
  return result;
}

std::vector<Expression*> expressions_of(Item& item) {
  return parts<Expression>(item);
}
std::vector<const Expression*> expressions_of(const Item& item) {
  return parts<const Expression>(item);
}

std::vector<Excerpt> excerpts(const File& file) {
  std::vector<Excerpt> result;
  for (const Item& item : file.items) {
    if (item.kind == Kind::claim) {
      Item about = item;
      about.claim.using_claims.clear();
      result.push_back({with_definitions(file, std::move(about)), item.name, item.name});
    }
    if (item.kind != Kind::table) continue;
    for (std::size_t r = 0; r < item.rows.size(); ++r) {
      Item about = item;
      about.rows = {item.rows[r]};
      const File alone = with_definitions(file, std::move(about));
      for (std::size_t k = 0; k < item.rows[r].printed.size(); ++k)
        result.push_back({alone, cell(item, r, k).id, cell(alone.items.back(), 0, k).id});
    }
  }
  return result;
}

}  // namespace seam::claims
