// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "geometry/contact.h"
#include "geometry/identity.h"
#include "geometry/side_contact.h"

// Two sides, raised to one degree, are one curve exactly if their control points are equal. So
// a pair of sides is one curve for all values of the variables, if all coordinates of the
// differences of control points vanish identically; it is one curve for no value, if one of
// these coordinates is a number other than 0; else it may be one for some values.
//
// The predicate is about all values at once. Proven along a pair that is always one curve, it
// holds. That its failure refutes has to be said of the other pairs:
//
//   None of them is ever one curve: at every value the predicate is the condition stated.
//
//   The coordinates are polynomials, and no other pair is always one curve. An identity that
//   fails is a polynomial f other than 0; so is the sum g_i of the squared differences of each
//   other pair, hence the product of f and all g_i, which is therefore not 0 at some values
//   inside any box: there no other pair is one curve, and the condition fails. An inequality
//   may fail at single values only, and there another pair might do: it refutes nothing. With
//   no pair that is always one curve, the product of the g_i says that there are values at
//   which no pair is one.
//
//   Else nothing is known.

namespace seam::geometry {
namespace {

enum class Agreement { always, never, sometimes };

Agreement agreement(const Curve& x, const Curve& y, const Numbers& numbers) {
  const int degree = std::max(x.degree(), y.degree());
  const auto a = elevate(x, degree).control, b = elevate(y, degree).control;
  bool always = true;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (const Formula& difference : a[i] - b[i]) {
      if (vanishes_identically(difference, numbers)) continue;
      if (is_nonzero_number(difference, numbers)) return Agreement::never;
      always = false;
    }
  return always ? Agreement::always : Agreement::sometimes;
}

struct Pairs {
  std::vector<Seam> always;
  bool sometimes = false;  // others are one curve for some values, or it is not known
};

Pairs pairs(const std::vector<Patch>& patches, const Numbers& numbers) {
  Pairs result;
  for (int side = 1; side <= patches[0].sides(); ++side)
    for (int other = 1; other <= patches[1].sides(); ++other)
      for (const bool reversed : {false, true}) {
        const Seam seam{0, side, 1, other, reversed};
        const Contact c = contact(patches, seam);
        const Agreement found = agreement(edge(c.p, 1), edge(c.q, 1), numbers);
        if (found == Agreement::always) result.always.push_back(seam);
        if (found == Agreement::sometimes) result.sometimes = true;
      }
  return result;
}

bool holds_polynomials(const Patch& p) {
  const auto is_polynomial_point = [](const Point& point) {
    return std::ranges::all_of(point, [](const Formula& x) { return is_polynomial(x); });
  };
  return std::ranges::all_of(p.rows(), [&](const std::vector<Point>& row) {
    return std::ranges::all_of(row, is_polynomial_point);
  });
}

Criterion::Failure meaning_of_failure(const Pairs& found, const std::vector<Patch>& patches) {
  if (!found.sometimes) return Criterion::Failure::refutes;
  if (!holds_polynomials(patches[0]) || !holds_polynomials(patches[1]))
    return Criterion::Failure::says_nothing;
  return found.always.empty() ? Criterion::Failure::refutes
                              : Criterion::Failure::refutes_by_identities;
}

}  // namespace

Criterion along_a_common_side(const Patch& p, const Patch& q, const Condition& condition,
                              const Numbers& numbers) {
  const std::vector<Patch> patches{p, q};
  const Pairs found = pairs(patches, numbers);
  const auto failure = meaning_of_failure(found, patches);
  std::vector<Proposition> alternatives;
  for (const Seam& seam : found.always) {
    Proposition alternative = condition(contact(patches, seam));
    alternative.about = name({seam.patch, seam.side}) + ", " +
                        name({seam.other_patch, seam.other_side}) +
                        (seam.reversed ? " reversed" : "");
    alternatives.push_back(std::move(alternative));
  }
  if (alternatives.size() == 1) return {alternatives.front(), failure};
  if (!alternatives.empty()) return {any(std::move(alternatives)), failure};

  const std::vector<SideIndex> sides = all_sides(patches);
  return {some_side_agrees(patches, {sides.begin(), sides.begin() + p.sides()},
                           {sides.begin() + p.sides(), sides.end()}),
          failure};
}

Proposition regular(const Patch& p) {
  const Point n = normal(p, Formula::symbol(parameter_u), Formula::symbol(parameter_v));
  return atom(symbolic::Sign{norm2(n), symbolic::Relation::positive,
                             domain(p, parameter_u, parameter_v)},
              "the normal is nowhere 0");
}

}  // namespace seam::geometry
