// SPDX-License-Identifier: GPL-3.0-or-later
#include "symbolic/atoms.h"

#include <algorithm>

#include "exact/contract.h"

namespace seam::symbolic {
namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);
constexpr std::size_t longest_name = 60;

}  // namespace

void Atoms::add(const Formula& f) {
  if (f.is_polynomial() || seen_.contains(f.identity())) return;
  for (const Formula& operand : f.operands()) add(operand);
  kept_.push_back(f);  // so that no other node can take its address
  std::size_t index = none;
  if (f.kind() == Formula::Kind::root || f.kind() == Formula::Kind::inverse ||
      f.kind() == Formula::Kind::applied) {
    const auto known =
        std::ranges::find_if(entries_, [&](const Entry& e) { return e.formula.same(f); });
    index = static_cast<std::size_t>(known - entries_.begin());
    if (known == entries_.end()) {
      std::string name = text(f, longest_name);
      // A name that breaks off may be that of another one too.
      if (name.size() >= longest_name ||
          std::ranges::any_of(entries_, [&](const Entry& e) { return e.name == name; }))
        name = "(" + std::to_string(entries_.size() + 1) + ") " + name;
      entries_.push_back({std::move(name), f});
    }
  }
  seen_.emplace(f.identity(), index);
}

const Atoms::Entry& Atoms::operator[](const Formula& f) const {
  const auto found = seen_.find(f.identity());
  if (found != seen_.end() && found->second != none) return entries_[found->second];
  const auto same =
      std::ranges::find_if(entries_, [&](const Entry& e) { return e.formula.same(f); });
  exact::require(same != entries_.end(), "Atoms: one that was not added");
  return *same;
}

}  // namespace seam::symbolic
