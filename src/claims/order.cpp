// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/order.h"

#include <algorithm>

#include "symbolic/coefficients.h"

// The pairs a <= b of an interval [l, h] are the triangle with the corners (l,l), (l,h), (h,h).
// Its facets: opposite (l,l) b = h, opposite (l,h) a = b, opposite (h,h) a = l. With a < b the
// ends a = h and b = l are left out anyway; with a <= b they are corners, so there the
// intervals must leave out the same ends.

namespace seam::claims {
namespace {

using symbolic::Constraint;
using symbolic::Simplex;

struct Order {
  std::string less, greater;
  bool strict = false;
};

std::optional<Order> order(const Constraint& constraint, const Numbers& numbers) {
  const auto variables = symbolic::variables(constraint.formula);
  if (variables.size() != 2) return std::nullopt;
  const std::string a = *variables.begin(), b = *variables.rbegin();
  const auto c = symbolic::coefficients(constraint.formula, {a, b}, numbers);
  const auto of_a = c.find({1, 0}), of_b = c.find({0, 1});
  if (c.size() != 2 || of_a == c.end() || of_b == c.end()) return std::nullopt;
  if (!numbers.equal(of_a->second, -of_b->second)) return std::nullopt;
  bool a_less = numbers.sign(of_a->second) == exact::Sign::positive;
  switch (constraint.relation) {
    case Relation::negative:
    case Relation::nonpositive:
      break;
    case Relation::positive:
    case Relation::nonnegative:
      a_less = !a_less;
      break;
    default:
      return std::nullopt;
  }
  const bool strict =
      constraint.relation == Relation::negative || constraint.relation == Relation::positive;
  return a_less ? Order{a, b, strict} : Order{b, a, strict};
}

bool is_bounded_interval(const Simplex& factor) {
  return factor.variables.size() == 1 && factor.corners[0][0].is(1) &&
         factor.corners[1][0].is(1);
}

std::optional<Simplex> triangle(const Order& order, const Simplex& less, const Simplex& greater,
                                const Numbers& numbers) {
  if (!is_bounded_interval(less) || !is_bounded_interval(greater)) return std::nullopt;
  const Formula &low = less.corners[0][1], &high = less.corners[1][1];
  if (!numbers.equal(low, greater.corners[0][1]) || !numbers.equal(high, greater.corners[1][1]))
    return std::nullopt;
  if (!order.strict && less.open != greater.open) return std::nullopt;
  // Facet 0 of an interval is its upper end.
  return Simplex{{order.less, order.greater},
                 {{1, low, low}, {1, low, high}, {1, high, high}},
                 {greater.open[0], order.strict, less.open[1]}};
}

bool apply(Context& context, const Order& order, const Numbers& numbers) {
  const auto factor_of = [&](const std::string& variable) {
    return std::ranges::find_if(context.factors, [&](const Simplex& factor) {
      return factor.variables == std::vector<std::string>{variable};
    });
  };
  const auto less = factor_of(order.less), greater = factor_of(order.greater);
  if (less == context.factors.end() || greater == context.factors.end()) return false;
  auto joint = triangle(order, *less, *greater, numbers);
  if (!joint) return false;
  *std::min(less, greater) = std::move(*joint);
  context.factors.erase(std::max(less, greater));
  return true;
}

}  // namespace

void order_to_triangle(Context& context, const Numbers& numbers) {
  for (std::size_t i = 0; i < context.where.size();) {
    const auto found = order(context.where[i], numbers);
    if (found && apply(context, *found, numbers))
      context.where.erase(context.where.begin() + static_cast<std::ptrdiff_t>(i));
    else
      ++i;
  }
}

}  // namespace seam::claims
