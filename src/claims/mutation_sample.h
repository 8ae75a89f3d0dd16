// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "claims/mutation.h"

namespace seam::claims {

/// So many different mutations of an excerpt, or all where there are fewer. Drawn evenly among
/// the kinds, half of them in the last item, which is the claim. The same seed draws the same.
std::vector<Mutation> sample(const File& excerpt, std::size_t count, std::uint64_t seed);

/// A number that depends on a seed and on every byte of a text.
std::uint64_t seed_of(std::uint64_t seed, const std::string& text);

/// Seeded random numbers, the same on every machine (SplitMix64).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }
  /// From 0 on, less than `end`, which is above 0.
  std::size_t below(std::size_t end) { return static_cast<std::size_t>(next() % end); }

 private:
  std::uint64_t state_;
};

}  // namespace seam::claims
