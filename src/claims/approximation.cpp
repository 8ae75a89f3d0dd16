// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/stating.h"

// E ~ d: E lies within half a unit of the last printed digit of d, both ends included (at an
// exact tie either neighbour is a correct rounding). Truncated: the digits of |E| were cut off,
// so |d| <= |E| < |d| + unit.

namespace seam::claims {
namespace {

using exact::Rational;
using Kind = Expression::Kind;

struct Printed {
  Rational value, unit;
  bool negative = false;
};

std::optional<Printed> printed_decimal(const Expression& e) {
  if (e.kind == Kind::negate) {
    auto inner = printed_decimal(e.children[0]);
    if (!inner) return std::nullopt;
    return Printed{-inner->value, inner->unit, !inner->negative};
  }
  if (e.kind != Kind::number) return std::nullopt;
  const auto point = e.text.find('.');
  const std::size_t places = point == std::string::npos ? 0 : e.text.size() - point - 1;
  exact::Integer scale;
  mpz_ui_pow_ui(scale.get_mpz_t(), 10, places);
  return Printed{decimal(e.text), Rational(exact::Integer(1), scale), false};
}

}  // namespace

std::pair<Rational, Rational> printed_range(const Expression& printed) {
  const auto decimal = printed_decimal(printed);
  if (!decimal)
    fail(printed, "expected a printed decimal after '~'",
         "an exact value is compared with '='");
  const Rational half = decimal->unit / 2;
  return {decimal->value - half, decimal->value + half};
}

Proposition Stating::approximation(const Expression& at, const Value& left,
                                   const Expression& printed, bool truncated,
                                   const Context& context, bool positive) {
  if (printed.kind == Kind::tuple || printed.kind == Kind::list) {
    const auto items = as_items(evaluator, left, at);
    if (items.size() != printed.children.size())
      fail(printed, "expected " + std::to_string(items.size()) + " printed values");
    std::vector<Proposition> parts;
    for (std::size_t i = 0; i < items.size(); ++i)
      parts.push_back(
          approximation(at, items[i], printed.children[i], truncated, context, true));
    Proposition all = symbolic::all(std::move(parts));
    if (positive) return all;
    if (!context.empty()) throw Unsupported("'not' of several printed values under 'for all'");
    return symbolic::negation(std::move(all));
  }
  const auto decimal = printed_decimal(printed);
  if (!decimal)
    fail(printed, "expected a printed decimal after '~'",
         "an exact value is compared with '='");
  const Rational half = decimal->unit / 2;
  Rational low = decimal->value - half, high = decimal->value + half;
  bool open_low = false, open_high = false;
  if (truncated) {
    const bool zero = decimal->value == 0;
    low = decimal->negative || zero ? Rational(decimal->value - decimal->unit) : decimal->value;
    high = decimal->negative ? decimal->value : Rational(decimal->value + decimal->unit);
    open_low = decimal->negative || zero;
    open_high = !decimal->negative;
  }
  Proposition above =
      compare(at, left, open_low ? ">" : ">=", {Scalar(Formula(low))}, context, true);
  Proposition below =
      compare(at, left, open_high ? "<" : "<=", {Scalar(Formula(high))}, context, true);
  above.about = "not below " + low.get_str();
  below.about = "not above " + high.get_str();
  const char* const unit =
      truncated ? "the last printed digit" : "half a unit of the last printed digit";
  const Formula size(truncated ? decimal->unit : half);
  Proposition both = in_units(symbolic::all({std::move(above), std::move(below)}), size, unit);
  if (positive) return both;
  if (!context.empty()) throw Unsupported("'not' of a printed value under 'for all'");
  return symbolic::negation(std::move(both));
}

}  // namespace seam::claims
