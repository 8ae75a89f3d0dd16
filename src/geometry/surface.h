// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "geometry/curvature.h"
#include "geometry/group.h"
#include "geometry/mesh.h"
#include "geometry/motion.h"
#include "geometry/patch.h"
#include "geometry/solids.h"
#include "symbolic/numbers.h"

namespace seam::geometry {

/// Two sides (1-based numbers as in `edge`) that are one curve.
struct Seam {
  int patch = 0, side = 0, other_patch = 0, other_side = 0;
  bool reversed = false;  ///< equal after u -> 1 - u
};

/// Where patches meet in a point: each patch once a corner it has there, in cyclic order round
/// the point where the seams form a cycle; `closed` says whether they do. Sector i leaves by
/// its `side_out`, which is glued to the `side_in` of sector i + 1.
struct Corner {
  struct Sector {
    int patch = 0;
    int side_in = 0, side_out = 0;  ///< the two sides of the patch that meet here
    bool in_starts_here = false,
         out_starts_here = false;  ///< which end of that side is the corner
  };
  std::vector<Sector> sectors;
  Point point;
  bool closed = false;
};

/// Patches glued along equal boundary curves. Patch coordinates are numbers.
struct Surface {
  std::vector<Patch> patches;
  std::vector<Seam>
      seams;  ///< every pair of equal sides (so a side may occur in several, or in none)
  std::vector<Corner>
      corners;  ///< found by following the seams: sheets that merely touch stay apart
};
Surface surface(std::vector<Patch>, const Numbers&);

/// Every pair of different sides that are one curve, in one direction or the other (forwards if
/// both).
std::vector<Seam> seams(const std::vector<Patch>&, const Numbers&);

/// Every corner of every patch, once, grouped through those sides that lie on exactly one seam.
std::vector<Corner> corners(const std::vector<Patch>&, const std::vector<Seam>&);

/// q after that symmetry of the parameter domain that gives it the net of p, if there is one.
std::optional<Patch> parametrised_like(const Patch& p, const Patch& q, const Numbers&);

/// All distinct images of a patch (distinct up to the symmetries of the parameter domain), the
/// patch itself first.
Surface orbit(const Patch&, const std::vector<Matrix>& group, const Numbers&);

}  // namespace seam::geometry
