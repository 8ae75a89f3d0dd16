// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/triangulation.h"

// A product of two simplices with corners a0..am and b0..bn is covered by those whose corners
// are the points (ai, bj) along a path of m + n unit steps from (0, 0) to (m, n), one for each
// path: a point with coordinates x0 + ... + xm = y0 + ... + yn = 1 lies in that of the path
// along which the partial sums of x and y are passed in ascending order.

namespace seam::claims {
namespace {

using symbolic::Simplex;

void walk(const Simplex& a, const Simplex& b, std::size_t i, std::size_t j, Simplex& path,
          std::vector<Simplex>& all) {
  symbolic::Point corner = a.corners[i];
  corner.insert(corner.end(), b.corners[j].begin() + 1, b.corners[j].end());
  path.corners.push_back(std::move(corner));
  if (i + 1 == a.corners.size() && j + 1 == b.corners.size()) all.push_back(path);
  if (i + 1 < a.corners.size()) walk(a, b, i + 1, j, path, all);
  if (j + 1 < b.corners.size()) walk(a, b, i, j + 1, path, all);
  path.corners.pop_back();
}

}  // namespace

std::vector<Simplex> triangulated(const std::vector<Simplex>& factors) {
  std::vector<Simplex> result = {factors[0]};
  for (std::size_t k = 1; k < factors.size(); ++k) {
    std::vector<Simplex> longer;
    for (const Simplex& s : result) {
      Simplex path{s.variables, {}, {}};
      path.variables.insert(path.variables.end(), factors[k].variables.begin(),
                            factors[k].variables.end());
      path.open.assign(path.variables.size() + 1, false);
      walk(s, factors[k], 0, 0, path, longer);
    }
    result = std::move(longer);
  }
  return result;
}

}  // namespace seam::claims
