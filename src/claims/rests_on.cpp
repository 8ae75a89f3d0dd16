// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/rests_on.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

// A name that a quantifier, a `solve`, a list, a limit or the header of a function binds is
// none of the file's where it is bound. Each item is looked into once, so this ends.

namespace seam::claims {
namespace {

using Kind = Expression::Kind;
using Names = std::set<std::string>;

bool is_binder(Kind kind) {
  return kind == Kind::each || kind == Kind::for_all || kind == Kind::for_some ||
         kind == Kind::solve;
}

// The names that a binding, or a list of names or bindings, binds.
void collect_bound(const Expression& e, Names& bound) {
  if (e.kind == Kind::name) bound.insert(e.text);
  if (e.kind == Kind::binding) return collect_bound(e.children[0], bound);
  if (e.kind == Kind::list || e.kind == Kind::tuple)
    for (const Expression& child : e.children) collect_bound(child, bound);
}

void collect_free(const Expression& e, Names bound, Names& free) {
  if (e.kind == Kind::name && !bound.contains(e.text)) free.insert(e.text);
  if (e.kind == Kind::limit) bound.insert(e.text);
  if (is_binder(e.kind))
    for (const Expression& child : e.children)
      if (child.kind == Kind::binding || (e.kind == Kind::solve && &child == &e.children[0]))
        collect_bound(child, bound);
  for (const Expression& child : e.children) collect_free(child, bound, free);
}

std::vector<const Expression*> parts_of(const Item& item) {
  std::vector<const Expression*> parts;
  for (const Expression& e : item.expressions) parts.push_back(&e);
  if (item.where) parts.push_back(&*item.where);
  return parts;
}

class Definitions {
 public:
  explicit Definitions(const std::vector<const Item*>& items) : items_(items) {
    for (const Item* item : items_) {
      for (const std::string& name : item->names) of_.emplace(name, item);
      if (item->names.empty()) of_.emplace(item->name, item);
    }
  }

  void need(const Expression& e, const std::vector<std::string>& parameters) {
    Names free;
    collect_free(e, Names(parameters.begin(), parameters.end()), free);
    for (const std::string& name : free) {
      const auto found = of_.find(name);
      if (found == of_.end() || !needed_.insert(found->second).second) continue;
      for (const Expression* part : parts_of(*found->second))
        need(*part, found->second->parameters);
    }
  }

  std::vector<const Item*> needed() const {
    std::vector<const Item*> result;
    std::ranges::copy_if(items_, std::back_inserter(result),
                         [this](const Item* item) { return needed_.contains(item); });
    return result;
  }

 private:
  std::vector<const Item*> items_;
  std::map<std::string, const Item*> of_;
  std::set<const Item*> needed_;
};

}  // namespace

std::vector<const Item*> rests_on(const std::vector<const Item*>& items,
                                  const std::vector<const Expression*>& expressions) {
  Definitions definitions(items);
  for (const Expression* e : expressions) definitions.need(*e, {});
  return definitions.needed();
}

std::vector<const Item*> rests_on(const Meaning& meaning, const Claim& claim) {
  std::vector<const Item*> definitions;
  for (const MeantItem& meant : meaning.items)
    if (const auto* definition = std::get_if<MeantDefinition>(&meant))
      definitions.push_back(&definition->item);
  std::vector<const Expression*> said = {&claim.statement};
  if (claim.corrected) said.push_back(&*claim.corrected);
  return rests_on(definitions, said);
}

}  // namespace seam::claims
