// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>

#include "geometry/contact.h"
#include "geometry/identity.h"
#include "geometry/side_contact.h"
#include "geometry/side_pairs.h"

// The predicate is about all values at once. Proven along a pair that is always one curve, it
// holds. That its failure refutes has to be said of the other pairs:
//
//   None of them is ever one curve: at every value the predicate is the condition stated.
//
//   The coordinates are rational functions, and no other pair is always one curve. An identity
//   that fails is a rational function f other than 0; so is the sum g_i of the squared
//   differences of each other pair, hence the product of f and all g_i, which is therefore not
//   0 at some values inside any box: there no other pair is one curve, and the condition fails.
//   An inequality may fail at single values only, and there another pair might do: it refutes
//   nothing. With no pair that is always one curve, the product of the g_i says that there are
//   values at which no pair is one.
//
//   At a sample, of polynomials, the predicate fails: at the pairs that are one curve there,
//   the condition has an identity that does not hold or an inequality that is wrong at 0, 1/2
//   or 1.
//
//   Else nothing is known.

namespace seam::geometry {
namespace {

bool all_coordinates(const Patch& p, bool (*property)(const Formula&)) {
  return std::ranges::all_of(p.rows(), [&](const std::vector<Point>& row) {
    return std::ranges::all_of(
        row, [&](const Point& point) { return std::ranges::all_of(point, property); });
  });
}

bool is_polynomial(const Formula& f) {
  return f.is_polynomial();
}

Patch at(const std::map<std::string, Formula>& values, const Patch& p) {
  return map(p, [&](const Point& point) {
    Point result;
    for (const Formula& x : point) result.push_back(subst(x, values));
    return result;
  });
}

bool is_in(exact::Sign sign, symbolic::Relation relation) {
  using symbolic::Relation;
  if (sign == exact::Sign::zero)
    return relation == Relation::zero || relation == Relation::nonnegative ||
           relation == Relation::nonpositive;
  if (relation == Relation::nonzero) return true;
  return sign == exact::Sign::positive
             ? relation == Relation::positive || relation == Relation::nonnegative
             : relation == Relation::negative || relation == Relation::nonpositive;
}

// Of a condition on patches of numbers, along a side.
bool surely_fails(const Proposition& p, const Search& search) {
  if (p.kind == Proposition::Kind::all)
    return std::ranges::any_of(
        p.parts, [&](const Proposition& part) { return surely_fails(part, search); });
  if (p.kind != Proposition::Kind::atom) return false;
  if (const auto* zero = std::get_if<symbolic::Zero>(&p.atom))
    return !search.vanishes(zero->formula);
  const auto* sign = std::get_if<symbolic::Sign>(&p.atom);
  const std::array<Formula, 3> places{0, Formula(exact::Rational(1, 2)), 1};
  return sign && std::ranges::any_of(places, [&](const Formula& u) {
           const Formula value = subst(sign->formula, {{parameter_u, u}});
           return is_number(value) && !is_in(search.numbers.sign(value), sign->relation);
         });
}

// Of polynomials: at some sample the predicate fails.
bool fails_at_a_sample(const Patch& p, const Patch& q, const Condition& condition,
                       const Search& search) {
  return std::ranges::any_of(search.samples, [&](const auto& values) {
    const std::vector<Patch> here{at(values, p), at(values, q)};
    const auto found = side_pairs(here[0], here[1], search.numbers, search.vanishes);
    return !found.sometimes && std::ranges::all_of(found.always, [&](const Seam& seam) {
      return surely_fails(condition(contact(here, seam)), search);
    });
  });
}

Criterion::Failure meaning_of_failure(const SidePairs& found, const Patch& p, const Patch& q,
                                      const Condition& condition, const Search& search) {
  using Failure = Criterion::Failure;
  if (!found.sometimes) return Failure::refutes;
  if (!all_coordinates(p, is_rational_function) || !all_coordinates(q, is_rational_function))
    return Failure::says_nothing;
  if (found.always.empty()) return Failure::refutes;
  const bool polynomials =
      all_coordinates(p, is_polynomial) && all_coordinates(q, is_polynomial);
  return polynomials && fails_at_a_sample(p, q, condition, search)
             ? Failure::refutes
             : Failure::refutes_by_identities;
}

}  // namespace

Criterion along_a_common_side(const Patch& p, const Patch& q, const Condition& condition,
                              const Search& search) {
  const std::vector<Patch> patches{p, q};
  const SidePairs found = side_pairs(p, q, search.numbers, search.vanishes);
  const auto failure = meaning_of_failure(found, p, q, condition, search);
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
