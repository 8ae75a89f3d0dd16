// SPDX-License-Identifier: GPL-3.0-or-later
#include <iterator>

#include "geometry/contact.h"
#include "geometry/nearness.h"

// A point that is no corner, no middle of a side and no centre of a patch may still be the
// image of some other parameter. Then the statement is that it is not away from all patches:
// positive distance from every patch refutes it.

namespace seam::geometry {
namespace {

using symbolic::Sign;
using symbolic::Zero;

std::vector<Point> places(const Patch& p) {
  std::vector<Point> result;
  result.reserve(2 * p.sides() + 1);
  for (int number = 0; number < p.sides(); ++number) result.push_back(corner(p, number));
  const Formula half(exact::Rational(1, 2)), third(exact::Rational(1, 3));
  for (int side = 1; side <= p.sides(); ++side) result.push_back(evaluate(edge(p, side), half));
  const Formula& centre = p.shape() == Patch::Shape::triangle ? third : half;
  result.push_back(evaluate(p, centre, centre));
  return result;
}

Proposition is_point(const Point& a, const Point& b) {
  std::vector<Proposition> parts;
  for (const Formula& difference : a - b) parts.push_back(atom(Zero{difference}));
  return all(std::move(parts), "the point is reached");
}

Proposition somewhere(const Surface& s, const Point& point) {
  std::vector<Proposition> alternatives;
  const Formula u = Formula::symbol(parameter_u), v = Formula::symbol(parameter_v);
  for (const Patch& patch : s.patches)
    alternatives.push_back(
        negation(atom(Sign{norm2(evaluate(patch, u, v) - point), symbolic::Relation::positive,
                           domain(patch, parameter_u, parameter_v)},
                      "the patch misses the point")));
  return any(std::move(alternatives), "some patch reaches the point");
}

}  // namespace

Proposition interpolates(const Surface& s, const std::vector<Point>& points,
                         const Numbers& numbers) {
  std::vector<Point> candidates;
  for (const Patch& patch : s.patches)
    std::ranges::move(places(patch), std::back_inserter(candidates));
  const PointIndex index(candidates, numbers);

  std::vector<Proposition> parts;
  for (const Point& point : points) {
    const auto found = index.find(point);
    parts.push_back(found ? is_point(candidates[*found], point) : somewhere(s, point));
  }
  return all(std::move(parts));
}

}  // namespace seam::geometry
