// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/gluing.h"

#include <algorithm>

#include "geometry/nearness.h"
#include "geometry/side_contact.h"

// A surface is closed when every side is on one seam and on no other. Stated is: the pairs
// found are equal curves (so every side is on a seam), they use up every side once (the
// gluing), and the curves of different seams are different (so no side is on a second). Curves
// are told apart by numbers that a reversed curve shares: their points at u = 1/2 where that is
// enough, else, with the control points P_0 .. P_n of one degree, all sums P_i + P_(n-i) and
// all products of two coordinates of the differences P_i - P_(n-i), i < n/2: a vector is known
// up to its sign from the products of its coordinates, so these are the same exactly for a
// curve and its reverse.

namespace seam::geometry {
namespace {

using certificate::Gluing;
using symbolic::all;
using symbolic::atom;

Gluing gluing(const Surface& s, int euler) {
  Gluing result;
  result.euler = euler;
  for (const Patch& patch : s.patches) {
    result.patches.emplace_back();
    for (int side = 1; side <= patch.sides(); ++side) {
      const auto [from, to] = ends(patch.shape(), side);
      result.patches.back().push_back({from, to});
    }
  }
  for (const Seam& seam : s.seams)
    result.seams.push_back(
        {seam.patch, seam.side - 1, seam.other_patch, seam.other_side - 1, seam.reversed});
  return result;
}

bool on_a_seam(const Surface& s, const SideIndex& side) {
  return std::ranges::any_of(s.seams, [&](const Seam& seam) {
    return (seam.patch == side.patch && seam.side == side.side) ||
           (seam.other_patch == side.patch && seam.other_side == side.side);
  });
}

std::vector<Point> midpoints(const std::vector<Curve>& curves) {
  std::vector<Point> result;
  result.reserve(curves.size());
  for (const Curve& curve : curves)
    result.push_back(evaluate(curve, Formula(exact::Rational(1, 2))));
  return result;
}

bool apart(const std::vector<Point>& points, const Numbers& numbers) {
  const auto approximations = approximate(points, numbers);
  for (std::size_t i = 0; i < approximations.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (near(approximations[i], approximations[j])) return false;
  return true;
}

std::vector<Point> symmetric_tuples(const std::vector<Curve>& curves) {
  int degree = 0;
  for (const Curve& curve : curves) degree = std::max(degree, curve.degree());
  std::vector<Point> result;
  for (const Curve& curve : curves) {
    const auto control = elevate(curve, degree).control;
    Point tuple, differences;
    for (int i = 0; 2 * i <= degree; ++i) {
      std::ranges::copy(control[i] + control[degree - i], std::back_inserter(tuple));
      std::ranges::copy(control[i] - control[degree - i], std::back_inserter(differences));
    }
    for (std::size_t a = 0; a < differences.size(); ++a)
      for (std::size_t b = 0; b <= a; ++b) tuple.push_back(differences[a] * differences[b]);
    result.push_back(std::move(tuple));
  }
  return result;
}

Proposition different_curves(const Surface& s, const Numbers& numbers) {
  std::vector<Curve> curves;
  for (const Seam& seam : s.seams) curves.push_back(edge(s.patches[seam.patch], seam.side));
  std::vector<Point> tuples = midpoints(curves);
  if (!apart(tuples, numbers)) tuples = symmetric_tuples(curves);
  return atom(symbolic::Distinct{std::move(tuples)}, "different seams are different curves");
}

}  // namespace

int euler_characteristic(const Surface& s) {
  return static_cast<int>(std::ssize(s.corners) - std::ssize(s.seams) + std::ssize(s.patches));
}

// A side on no seam fails with a witness: it differs from every other.
Proposition closed(const Surface& s, int euler, const Numbers& numbers) {
  std::vector<Proposition> parts{
      atom(gluing(s, euler),
           "every side on one seam, connected, Euler characteristic " + std::to_string(euler))};
  const std::vector<SideIndex> sides = all_sides(s.patches);
  const auto open =
      std::ranges::find_if(sides, [&](const SideIndex& side) { return !on_a_seam(s, side); });
  if (open != sides.end()) {
    parts.push_back(some_side_agrees(s.patches, {*open}, sides));
    parts.back().about = name(*open) + " is glued to another side";
    return all(std::move(parts));
  }

  for (const Seam& seam : s.seams) {
    parts.push_back(g0(contact(s.patches, seam)));
    parts.back().about =
        name({seam.patch, seam.side}) + " is " + name({seam.other_patch, seam.other_side});
  }
  parts.push_back(different_curves(s, numbers));
  return all(std::move(parts));
}

Proposition closed(const Surface& s, const Numbers& numbers) {
  return closed(s, euler_characteristic(s), numbers);
}

}  // namespace seam::geometry
