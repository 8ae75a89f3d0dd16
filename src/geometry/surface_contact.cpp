// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>

#include "geometry/contact.h"
#include "geometry/side_contact.h"
#include "geometry/winding.h"

namespace seam::geometry {
namespace {

using Condition = Proposition (*)(const Contact&);

// The patches that hang together with the first through seams.
std::vector<bool> reached_from_first(const Surface& s) {
  std::vector<bool> reached(s.patches.size());
  if (!reached.empty()) reached[0] = true;
  for (bool grown = true; grown;) {
    grown = false;
    for (const Seam& seam : s.seams)
      if (reached[seam.patch] != reached[seam.other_patch]) {
        reached[seam.patch] = reached[seam.other_patch] = true;
        grown = true;
      }
  }
  return reached;
}

Proposition one_more_seam(const Surface& s, const std::vector<bool>& reached) {
  std::vector<SideIndex> inside, outside;
  for (const SideIndex& side : all_sides(s.patches))
    (reached[side.patch] ? inside : outside).push_back(side);
  Proposition result = some_side_agrees(s.patches, inside, outside);
  result.about = "the patches hang together";
  return result;
}

Proposition smooth(const Surface& s, Condition condition, const std::string& what) {
  std::vector<Proposition> parts;
  const std::vector<bool> reached = reached_from_first(s);
  if (!std::ranges::all_of(reached, std::identity()))
    parts.push_back(one_more_seam(s, reached));
  for (const Seam& seam : s.seams) {
    Proposition along_seam = condition(contact(s.patches, seam));
    along_seam.about = what + " across " + name({seam.patch, seam.side}) + ", " +
                       name({seam.other_patch, seam.other_side});
    parts.push_back(std::move(along_seam));
  }
  int interior = 0;
  for (const Corner& corner : s.corners) {
    if (!corner.closed) continue;
    parts.push_back(winds_once(s, corner));
    ++interior;
  }
  return all(std::move(parts), what + " across " + std::to_string(s.seams.size()) +
                                   " seams and round " + std::to_string(interior) +
                                   " interior corners");
}

}  // namespace

Proposition g1(const Surface& s, const Numbers&) {
  return smooth(s, g1, "G1");
}

Proposition g2(const Surface& s, const Numbers&) {
  return smooth(s, g2, "G2");
}

}  // namespace seam::geometry
