// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include <algorithm>
#include <utility>

#include "check/partition.h"
#include "check/rules.h"

// Corners and patches are merged along seams; what is left of each is counted. Only
// discs are judged: the sides of each patch must form one closed polygon through all
// its corners, or V - E + F would mean nothing.

namespace seam::check {
namespace {

using certificate::Gluing;

// As many sides as corners, two at each corner, connected: one closed polygon.
bool is_polygon(const std::vector<Gluing::Side>& sides) {
  std::vector<int> ends(sides.size(), 0);
  Partition corners(sides.size());
  for (const auto& [from, to] : sides) {
    ++ends[static_cast<std::size_t>(from)];
    ++ends[static_cast<std::size_t>(to)];
    corners.merge(static_cast<std::size_t>(from), static_cast<std::size_t>(to));
  }
  return corners.classes() == 1 && std::ranges::all_of(ends, [](int n) { return n == 2; });
}

}  // namespace

bool decide(Context& context, const Gluing& gluing, const certificate::Proof& proof) {
  demand(std::holds_alternative<certificate::Computation>(proof),
         "evidence of a kind that says nothing of a gluing");
  demand(!gluing.patches.empty(), "degenerate: no patch");
  std::vector<std::size_t> first;  // corner (and side) number of each patch among all
  std::size_t corner_count = 0;
  for (const auto& sides : gluing.patches) {
    context.meter().charge(sides.size());
    demand(is_polygon(sides), "degenerate: the sides of a patch do not form a closed polygon");
    first.push_back(corner_count);
    corner_count += sides.size();
  }

  Partition corners(corner_count);
  Partition patches(gluing.patches.size());
  std::vector<int> seams_of_side(corner_count, 0);
  for (const auto& seam : gluing.seams) {
    context.meter().charge(1);
    const auto p = static_cast<std::size_t>(seam.patch);
    const auto q = static_cast<std::size_t>(seam.other_patch);
    const auto s = static_cast<std::size_t>(seam.side);
    const auto t = static_cast<std::size_t>(seam.other_side);
    ++seams_of_side[first[p] + s];
    ++seams_of_side[first[q] + t];
    patches.merge(p, q);
    const auto& side = gluing.patches[p][s];
    auto [from, to] = gluing.patches[q][t];
    if (seam.reversed) std::swap(from, to);
    corners.merge(first[p] + static_cast<std::size_t>(side.from),
                  first[q] + static_cast<std::size_t>(from));
    corners.merge(first[p] + static_cast<std::size_t>(side.to),
                  first[q] + static_cast<std::size_t>(to));
  }
  const bool is_closed = std::ranges::all_of(seams_of_side, [](int n) { return n == 1; });
  const long characteristic =
      corners.classes() - std::ssize(gluing.seams) + std::ssize(gluing.patches);
  return is_closed && patches.classes() == 1 && characteristic == gluing.euler;
}

}  // namespace seam::check
