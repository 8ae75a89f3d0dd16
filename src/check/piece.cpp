// SPDX-License-Identifier: GPL-3.0-or-later OR BSL-1.0
#include "check/piece.h"

#include <algorithm>
#include <utility>

#include "check/relation.h"

// Why `part` is right. With l the coordinates in the piece and m those in the part,
//     sum m_j corner_j (j != i) + m_i sum w_j corner_j
// is the point with l_j = m_j + w_j m_i (j != i) and l_i = w_i m_i.
// The latter is put in first: what the others bring in is m_i already.
//
// Why plain coefficients show f > 0 on the region in the piece, f = F(l) up to a positive
// factor.
//
//   A point there has coordinates l >= 0. Let S_m be the corners of factor m with l > 0.
//   For an open facet i of the region its coordinate lambda_i = sum l_j lambda_i(corner_j) is
//   positive, hence S_m holds a corner with a share in original corner i; and its weight is
//   positive, hence S_m holds a corner with a share in an original corner of positive weight.
//   (All lambda and weights are >= 0, so that a sum is positive exactly where a summand is.)
//   Let S_m' be a minimal subset of S_m that still meets these conditions. If some monomial
//   in the corners of the S_m' alone has a positive coefficient, it is positive at
//   l; and when no coefficient is negative, F(l) > 0. It is asked of every choice of
//   minimal subsets, one for each factor.
//
//   Of a condition g R 0 of the region, the monomials in the corners of the S_m alone are
//   positive at l, the others 0: g is 0 at l if there are none of the former, and has a strict
//   sign if their coefficients have one. If that is not as R asks, l is no point of the region.
//   Where the region has conditions, every choice of subsets is looked at, not the minimal
//   alone, and those are passed over on which one is broken.
//
// All this is about formulas in the coordinates alone. A symbol that has none, such as a
// logarithm, may have any sign: what holds it shows nothing.
//
// Shares are a matter of booleans: weights of a split are >= 0, their signs known.

namespace seam::check {
namespace {

using certificate::Relation;

// The sets of corners whose inner points belong to the factor: all, or the smallest.
std::vector<Corners> faces_inside(const Factor& factor, const std::vector<Corners>& supports,
                                  bool all, Meter& meter) {
  std::vector<Corners> conditions = {factor.finite};
  for (std::size_t i = 0; i < factor.open.size(); ++i)
    if (factor.open[i]) conditions.push_back(Corners{1} << i);

  std::vector<Corners> found;
  for (Corners face = 1; face < Corners{1} << supports.size(); ++face) {
    meter.charge(supports.size() + conditions.size() + found.size());
    Corners shares = 0;
    for (std::size_t j = 0; j < supports.size(); ++j)
      if ((face >> j & 1) != 0) shares |= supports[j];
    const bool is_inside = std::ranges::all_of(
        conditions, [shares](Corners condition) { return (shares & condition) != 0; });
    const bool is_wanted = all || std::ranges::none_of(found, [face](Corners smaller) {
                             return (smaller & face) == smaller;  // subsets come before
                           });
    if (is_inside && is_wanted) found.push_back(face);
  }
  return found;
}

// The corners of each factor that a monomial holds.
std::vector<Corners> corners_in(const Monomial& monomial, const Region& region) {
  std::vector<Corners> result;
  for (const Factor& factor : region.factors) {
    Corners held = 0;
    for (std::size_t j = 0; j < factor.corners.size(); ++j)
      if (exponent(monomial, factor.first + static_cast<int>(j)) > 0) held |= Corners{1} << j;
    result.push_back(held);
  }
  return result;
}

bool lies_in(const std::vector<Corners>& held, const std::vector<std::vector<Corners>>& faces,
             const std::vector<std::size_t>& choice) {
  for (std::size_t m = 0; m < held.size(); ++m)
    if ((held[m] & ~faces[m][choice[m]]) != 0) return false;
  return true;
}

// Steps to the next choice of one entry from each list; false after the last.
bool advance(std::vector<std::size_t>& choice, const std::vector<std::vector<Corners>>& lists) {
  for (std::size_t m = 0; m < choice.size(); ++m) {
    if (++choice[m] < lists[m].size()) return true;
    choice[m] = 0;
  }
  return false;
}

using Held = std::vector<std::vector<Corners>>;  // by monomial, then by factor

bool some_lies_in(const Held& monomials, const std::vector<std::vector<Corners>>& faces,
                  const std::vector<std::size_t>& choice) {
  return std::ranges::any_of(monomials,
                             [&](const auto& held) { return lies_in(held, faces, choice); });
}

// A condition over a piece: its monomials by the sign of the coefficient, in both lists where
// that is not known.
struct Signs {
  Relation relation;
  Held positive, negative;
};

std::vector<Signs> signs_of_conditions(Context& context, const Region& region,
                                       const Piece& piece) {
  std::vector<Signs> result;
  for (std::size_t i = 0; i < region.where.size(); ++i) {
    if (!piece.is_over_factors[i + 1]) continue;
    Signs& signs = result.emplace_back();
    signs.relation = region.where[i].relation;
    const auto coefficients =
        by_monomial(piece.formulas[i + 1], context.tower().size(), context.meter());
    for (const auto& [monomial, coefficient] : coefficients) {
      const int sign = context.tower().find_sign(coefficient).value_or(2);
      if (sign > 0) signs.positive.push_back(corners_in(monomial, region));
      if (sign < 0 || sign == 2) signs.negative.push_back(corners_in(monomial, region));
    }
  }
  return result;
}

// Whether it is broken at all inner points of the faces.
bool is_broken(const Signs& condition, const std::vector<std::vector<Corners>>& faces,
               const std::vector<std::size_t>& choice) {
  const bool above = some_lies_in(condition.positive, faces, choice);
  const bool below = some_lies_in(condition.negative, faces, choice);
  return !(above && below) && !holds(condition.relation, above ? 1 : below ? -1 : 0);
}

bool meets_every_face(Context& context, const Region& region, const Piece& piece,
                      const Held& positive) {
  const std::vector<Signs> conditions = signs_of_conditions(context, region, piece);
  std::size_t monomials = positive.size();
  for (const Signs& signs : conditions)
    monomials += signs.positive.size() + signs.negative.size();
  std::vector<std::vector<Corners>> faces;
  for (std::size_t m = 0; m < region.factors.size(); ++m) {
    faces.push_back(faces_inside(region.factors[m], piece.supports[m], !conditions.empty(),
                                 context.meter()));
    if (faces.back().empty()) return true;  // the piece holds no point of the region
  }
  std::vector<std::size_t> choice(faces.size(), 0);
  do {
    context.meter().charge(monomials * faces.size());
    if (some_lies_in(positive, faces, choice)) continue;
    const bool is_excluded = std::ranges::any_of(conditions, [&](const Signs& condition) {
      return is_broken(condition, faces, choice);
    });
    if (!is_excluded) return false;
  } while (advance(choice, faces));
  return true;
}

}  // namespace

Piece whole(Context& context, const Region& region, const Polynomial& formula) {
  Piece piece;
  std::set<int> coordinates;
  for (const Factor& factor : region.factors)
    coordinates.insert(factor.variables.begin(), factor.variables.end());
  const auto add = [&](const Polynomial& f) {
    piece.formulas.push_back(in_barycentric(context, region, f));
    piece.is_over_factors.push_back(context.depends_only_on(f, coordinates));
  };
  add(formula);
  for (const Condition& condition : region.where) add(condition.formula);
  for (const Factor& factor : region.factors) {
    std::vector<Corners>& supports = piece.supports.emplace_back();
    for (std::size_t j = 0; j < factor.corners.size(); ++j) supports.push_back(Corners{1} << j);
  }
  return piece;
}

Piece part(Context& context, const Region& region, const Piece& piece, std::size_t factor,
           const Coordinates& weights, std::size_t i) {
  Ring& ring = context.ring();
  const auto place = [&](std::size_t j) {
    return region.factors[factor].first + static_cast<int>(j);
  };
  Piece result = piece;
  ++result.depth;
  std::size_t held = 0;
  for (Polynomial& formula : result.formulas) {
    const Polynomial share = symbol(place(i));
    formula = ring.substitute(formula, place(i), ring.product(weights[i], share));
    for (std::size_t j = 0; j < weights.size(); ++j)
      if (j != i && !weights[j].is_zero())
        formula = ring.substitute(formula, place(j),
                                  ring.sum(symbol(place(j)), ring.product(weights[j], share)));
    formula.denominator = 1;  // a positive multiple
    held += words(formula);
  }
  demand(held <= 2 * Meter::max_words / static_cast<std::size_t>(result.depth), "effort");

  Corners shares = 0;
  for (std::size_t j = 0; j < weights.size(); ++j)
    if (context.tower().sign(weights[j]) > 0) shares |= piece.supports[factor][j];
  result.supports[factor][i] = shares;
  return result;
}

bool is_plain(Context& context, const Region& region, const Piece& piece, std::size_t formula,
              Relation relation) {
  const bool upward = relation == Relation::positive || relation == Relation::nonnegative;
  const bool downward = relation == Relation::negative || relation == Relation::nonpositive;
  if (!piece.is_over_factors[formula] || (!upward && !downward)) return false;

  std::vector<std::vector<Corners>> positive;
  const auto coefficients =
      by_monomial(piece.formulas[formula], context.tower().size(), context.meter());
  for (const auto& [monomial, coefficient] : coefficients) {
    const int sign = context.tower().sign(coefficient) * (upward ? 1 : -1);
    if (sign < 0) return false;
    if (sign > 0) positive.push_back(corners_in(monomial, region));
  }
  return holds(relation, 0) || meets_every_face(context, region, piece, positive);
}

}  // namespace seam::check
