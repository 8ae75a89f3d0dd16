// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <tuple>

#include "geometry/nearness.h"
#include "geometry/surface.h"

// Two curves in Bézier form are equal if and only if their control points are, once both are
// raised to one degree. Equal sides, in either direction, have nearly equal keys, so in the
// order of the keys each side is compared with its near neighbours only.

namespace seam::geometry {
namespace {

// A number that is the same for the reversed side, and the sum of the absolute values of its
// terms.
struct Key {
  double value = 0, size = 0;
};

struct Side {
  int patch, number;
  std::vector<Point> control;
  std::vector<Approximation> approximate_control;
  Key key;
};

Key key(const std::vector<Approximation>& control) {
  Key result;
  double weight = 1;
  for (std::size_t coordinate = 0; coordinate < control[0].size(); ++coordinate) {
    weight *= 0.7390851;  // so that the symmetries of a surface do not make keys equal
    for (std::size_t i = 0; i < control.size(); ++i) {
      const auto from_end = static_cast<double>(1 + std::min(i, control.size() - 1 - i));
      result.value += weight * from_end * control[i][coordinate];
      result.size += weight * from_end * std::abs(control[i][coordinate]);
    }
  }
  return result;
}

std::vector<Side> sides(const std::vector<Patch>& patches, const Numbers& numbers) {
  int degree = 0;
  for (const Patch& patch : patches)
    degree = std::max({degree, patch.degree_u(), patch.degree_v()});
  std::vector<Side> result;
  for (int p = 0; p < std::ssize(patches); ++p)
    for (int k = 1; k <= patches[p].sides(); ++k) {
      auto control = elevate(edge(patches[p], k), degree).control;
      auto approximations = approximate(control, numbers);
      const Key here = key(approximations);
      result.push_back({p, k, std::move(control), std::move(approximations), here});
    }
  return result;
}

bool one_curve(const Side& a, Side b, bool reversed, const Numbers& numbers) {
  if (reversed) {
    std::ranges::reverse(b.control);
    std::ranges::reverse(b.approximate_control);
  }
  return std::ranges::equal(
             a.approximate_control, b.approximate_control,
             [](const Approximation& x, const Approximation& y) { return near(x, y); }) &&
         std::ranges::equal(a.control, b.control, [&](const Point& x, const Point& y) {
           return equal(x, y, numbers);
         });
}

}  // namespace

std::vector<Seam> seams(const std::vector<Patch>& patches, const Numbers& numbers) {
  std::vector<Side> all = sides(patches, numbers);
  std::ranges::sort(all, {}, [](const Side& side) {
    return std::tuple(side.key.value, side.patch, side.number);
  });

  double size = 0;
  for (const Side& side : all) size = std::max(size, side.key.size);

  std::vector<Seam> result;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      if (!near(all[i].key.value, all[j].key.value, size)) break;
      const bool in_order =
          std::tie(all[i].patch, all[i].number) < std::tie(all[j].patch, all[j].number);
      const Side &a = in_order ? all[i] : all[j], &b = in_order ? all[j] : all[i];
      for (const bool reversed : {false, true})
        if (one_curve(a, b, reversed, numbers)) {
          result.push_back({a.patch, a.number, b.patch, b.number, reversed});
          break;
        }
    }
  std::ranges::sort(result, {}, [](const Seam& seam) {
    return std::tuple(seam.patch, seam.side, seam.other_patch, seam.other_side);
  });
  return result;
}

}  // namespace seam::geometry
