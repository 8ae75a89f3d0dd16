// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "geometry/surface.h"

// An end of a side meets at most one other end: that of the side it is glued to. So from a
// sector, left through one of its two sides, the next sector is determined, and from that one
// the way back: the walk runs along a path or round a cycle, and passes a sector once. (It
// cannot come back to one through the side it left by: then, by the way back, some end would be
// glued to itself.)

namespace seam::geometry {
namespace {

struct SideEnd {
  int patch, side;
  bool start;
  bool operator==(const SideEnd&) const = default;
  bool operator<(const SideEnd& other) const {
    return std::tie(patch, side, start) < std::tie(other.patch, other.side, other.start);
  }
};

using Gluing = std::map<SideEnd, SideEnd>;

Gluing glue(const std::vector<Seam>& seams) {
  std::map<std::pair<int, int>, int> occurrences;
  for (const Seam& seam : seams) {
    ++occurrences[{seam.patch, seam.side}];
    ++occurrences[{seam.other_patch, seam.other_side}];
  }
  Gluing result;
  for (const Seam& seam : seams) {
    if (occurrences[{seam.patch, seam.side}] > 1 ||
        occurrences[{seam.other_patch, seam.other_side}] > 1)
      continue;
    for (const bool start : {false, true}) {
      const SideEnd end{seam.patch, seam.side, start};
      const SideEnd other{seam.other_patch, seam.other_side, start != seam.reversed};
      result.insert({end, other});
      result.insert({other, end});
    }
  }
  return result;
}

// A corner of a patch, come to through one side and left through the other.
struct Passage {
  SideEnd in, out;
};

int corner_of(const SideEnd& end, const std::vector<Patch>& patches) {
  const auto [from, to] = ends(patches[end.patch].shape(), end.side);
  return end.start ? from : to;
}

// The other side that ends in the same corner of the patch.
SideEnd beside(const SideEnd& end, const std::vector<Patch>& patches) {
  const int here = corner_of(end, patches);
  for (int side = 1; side <= patches[end.patch].sides(); ++side)
    for (const bool start : {true, false}) {
      const SideEnd other{end.patch, side, start};
      if (side != end.side && corner_of(other, patches) == here) return other;
    }
  return end;  // not reached: two sides meet in every corner
}

class Walk {
 public:
  Walk(const std::vector<Patch>& patches, const Gluing& gluing)
      : patches_(patches), gluing_(gluing) {}

  Corner corner(int patch, int number) const {
    const Passage first = passage(patch, number);
    auto forward = walk(first);
    const bool closed =
        gluing_.contains(forward.back().out) && gluing_.at(forward.back().out) == first.in;
    if (!closed) {  // an open fan: from its one end to its other
      auto backward = walk({first.out, first.in});
      const Passage last = backward.back();
      forward = walk({last.out, last.in});
    }
    Corner result{{}, geometry::corner(patches_[patch], number), closed};
    for (const auto& [in, out] : forward)
      result.sectors.push_back({in.patch, in.side, out.side, in.start, out.start});
    return result;
  }

 private:
  Passage passage(int patch, int number) const {
    for (int side = 1;; ++side)
      for (const bool start : {true, false}) {
        const SideEnd end{patch, side, start};
        if (corner_of(end, patches_) == number) return {end, beside(end, patches_)};
      }
  }

  std::vector<Passage> walk(const Passage& first) const {
    std::vector<Passage> result{first};
    for (;;) {
      const auto next = gluing_.find(result.back().out);
      if (next == gluing_.end() || next->second == first.in) return result;
      result.push_back({next->second, beside(next->second, patches_)});
    }
  }

  const std::vector<Patch>& patches_;
  const Gluing& gluing_;
};

}  // namespace

std::vector<Corner> corners(const std::vector<Patch>& patches, const std::vector<Seam>& seams) {
  const Gluing gluing = glue(seams);
  const Walk walk(patches, gluing);
  std::set<std::pair<int, int>> seen;
  std::vector<Corner> result;
  for (int patch = 0; patch < std::ssize(patches); ++patch)
    for (int number = 0; number < patches[patch].sides(); ++number) {
      if (seen.contains({patch, number})) continue;
      result.push_back(walk.corner(patch, number));
      for (const Corner::Sector& sector : result.back().sectors)
        seen.insert(
            {sector.patch,
             corner_of({sector.patch, sector.side_in, sector.in_starts_here}, patches)});
    }
  return result;
}

Surface surface(std::vector<Patch> patches, const Numbers& numbers) {
  Surface result;
  result.patches = std::move(patches);
  result.seams = seams(result.patches, numbers);
  result.corners = corners(result.patches, result.seams);
  return result;
}

}  // namespace seam::geometry
