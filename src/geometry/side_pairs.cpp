// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/side_pairs.h"

#include <algorithm>

#include "geometry/side_contact.h"

// Two sides, raised to one degree, are one curve exactly if their control points are equal. So
// a pair of sides is one curve for all values of the variables, if all coordinates of the
// differences of control points vanish identically; it is one curve for no value, if one of
// these coordinates is a number other than 0; else it may be one for some values.

namespace seam::geometry {
namespace {

enum class Agreement { always, never, sometimes };

Agreement agreement(const Curve& x, const Curve& y, const Numbers& numbers,
                    const Vanishing& vanishes) {
  const int degree = std::max(x.degree(), y.degree());
  const auto a = elevate(x, degree).control, b = elevate(y, degree).control;
  bool always = true;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (const Formula& difference : a[i] - b[i]) {
      if (vanishes(difference)) continue;
      if (is_nonzero_number(difference, numbers)) return Agreement::never;
      always = false;
    }
  return always ? Agreement::always : Agreement::sometimes;
}

}  // namespace

SidePairs side_pairs(const Patch& p, const Patch& q, const Numbers& numbers,
                     const Vanishing& vanishes) {
  const std::vector<Patch> patches{p, q};
  SidePairs result;
  for (int side = 1; side <= patches[0].sides(); ++side)
    for (int other = 1; other <= patches[1].sides(); ++other)
      for (const bool reversed : {false, true}) {
        const Seam seam{0, side, 1, other, reversed};
        const Contact c = contact(patches, seam);
        const Agreement found = agreement(edge(c.p, 1), edge(c.q, 1), numbers, vanishes);
        if (found == Agreement::always) result.always.push_back(seam);
        if (found == Agreement::sometimes) result.sometimes = true;
      }
  return result;
}

}  // namespace seam::geometry
