// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/mutation_sample.h"

#include <map>

// Numbers outnumber all other kinds by far, and definitions the claims; so what is drawn first
// is whether the claim or a definition is changed, then the kind, then the place.

namespace seam::claims {

std::uint64_t seed_of(std::uint64_t seed, const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325U ^ seed;  // FNV-1a
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  return hash;
}

std::vector<Mutation> sample(const File& excerpt, std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::map<Mutation::Kind, std::vector<Mutation>> of_claim, of_definitions;
  for (Mutation& mutation : mutations(excerpt)) {
    const bool is_claim = mutation.item + 1 == excerpt.items.size();
    (is_claim ? of_claim : of_definitions)[mutation.kind].push_back(std::move(mutation));
  }
  std::vector<Mutation> drawn;
  while (drawn.size() < count && !(of_claim.empty() && of_definitions.empty())) {
    const bool wants_claim = random.below(2) == 0;
    auto& groups = of_definitions.empty() || (wants_claim && !of_claim.empty())
                       ? of_claim
                       : of_definitions;
    auto group = groups.begin();
    std::advance(group, random.below(groups.size()));
    std::vector<Mutation>& rest = group->second;
    std::swap(rest[random.below(rest.size())], rest.back());
    drawn.push_back(std::move(rest.back()));
    rest.pop_back();
    if (rest.empty()) groups.erase(group);
  }
  return drawn;
}

}  // namespace seam::claims
