// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/item_reader.h"
#include "claims/stating.h"

// A question becomes the statement that the value lies within half a unit of the last digit of
// the decimal that is given. The exact value of an extremum rests on the place where it is
// attained; if that cannot be named, or the proof is too hard, its decimal can still be shown:
// nowhere more than half a unit above, and somewhere at least half a unit below.

namespace seam::claims {
namespace {

constexpr int max_digits = 10'000;
constexpr int max_digits_of_enclosure = 1000;

struct Printed {
  exact::Rational value, half;  ///< half a unit of the last digit
};

Printed printed(const std::string& text, int digits) {
  exact::Integer scale;
  mpz_ui_pow_ui(scale.get_mpz_t(), 10, digits);
  const bool negative = text.starts_with('-');
  const exact::Rational size = decimal(text.substr(negative ? 1 : 0));
  return {negative ? exact::Rational(-size) : size,
          exact::Rational(exact::Integer(1), exact::Integer(2 * scale))};
}

Proposition not_negative(const Formula& number, const std::string& about) {
  return symbolic::atom(symbolic::Sign{number, Relation::nonnegative, {}}, about);
}

constexpr const char* not_below = "not below the printed value";
constexpr const char* not_above = "not above the printed value";

// With an isolating interval for each root that no radical names.
std::string closed_form_of(const Formula& value, const Numbers& numbers) {
  std::string result = symbolic::text(value, 2000);
  const auto symbols = symbolic::symbols(value);
  for (const auto& generator : numbers.generators())
    if (symbols.contains(generator.name) && generator.name.starts_with("root("))
      result += ", " + generator.name + " in [" + generator.low.get_str() + ", " +
                generator.high.get_str() + "]";
  return result;
}

}  // namespace

void Reader::answer(MeantAsk& ask, const Formula& number, const std::string& decimal,
                    int digits) {
  const auto [value, half] = printed(decimal, digits);
  Stated stated;
  stated.goal =
      symbolic::all({not_negative(number - Formula(exact::Rational(value - half)), not_below),
                     not_negative(Formula(exact::Rational(value + half)) - number, not_above)});
  stated.guards = evaluator_.sides;
  ask.decimal = decimal;
  ask.closed_form = closed_form_of(meaning_.numbers->normal_form(number), *meaning_.numbers);
  ask.statement.exported = exported(stated, *meaning_.numbers);
}

void Reader::enclose(MeantAsk& ask, const Extremum& extremum, int digits) {
  const Attained near = nearly_attained(evaluator_, extremum, digits * 10L / 3 + 64);
  if (ask.decimal.empty()) ask.decimal = meaning_.numbers->decimal(near.value, digits);
  const auto [value, half] = printed(ask.decimal, digits);
  const bool max = extremum.maximum;
  const exact::Rational low = value - half, high = value + half;
  const Scalar outer(Formula(max ? high : low)), inner(Formula(max ? low : high));
  Stating stating(evaluator_);
  Proposition bounded =
      stating.everywhere(ask.expression, extremum, max ? "<=" : ">=", outer, {}, false);
  bounded.about = max ? not_above : not_below;
  const symbolic::Constraint c =
      stating.compared(near.here, max ? ">=" : "<=", inner, {}, ask.expression);
  Stated stated;
  stated.goal = symbolic::all(
      {std::move(bounded),
       stating.holds(c.formula, c.relation, {}, ask.expression, max ? not_below : not_above)});
  stated.guards = std::move(stating.guards);
  stated.guards.insert(stated.guards.end(), evaluator_.sides.begin(), evaluator_.sides.end());
  ask.enclosure.emplace().exported = exported(stated, *meaning_.numbers);
}

MeantAsk Reader::question(const std::string& id, const Expression& expression, int digits) {
  MeantAsk result{id, expression, {}, {}, {}, {}};
  evaluator_.sides.clear();
  std::optional<Value> value;
  try {
    if (digits < 0 || digits > max_digits) fail(expression, "expected at most 10000 digits");
    within_limits(expression.span, " of " + id, "it",
                  [&] { value = evaluator_.evaluate(expression, Scope{}); });
    const std::vector<Proposition> sides = evaluator_.sides;
    within_limits(expression.span, " of " + id + ", exactly", "it", [&] {
      const Formula number =
          as_number(evaluator_, evaluator_.resolved(*value, expression), expression);
      answer(result, number, meaning_.numbers->decimal(number, digits), digits);
    });
    evaluator_.sides = sides;
  } catch (const Unsupported& unsupported) {
    result.statement.unsupported = unsupported.what();
    result.statement.reason = unsupported.reason;
  } catch (const symbolic::NumberLimit& limit) {
    result.statement.unsupported = limit.what();
  }
  const auto* extremum = value ? value->as<Extremum>() : nullptr;
  try {
    if (extremum && digits <= max_digits_of_enclosure)
      within_limits(expression.span, " of " + id + ", as a decimal", "it",
                    [&] { enclose(result, *extremum, digits); });
  } catch (const Unsupported&) {  // the statement says why
  } catch (const symbolic::NumberLimit&) {
  }
  evaluator_.sides.clear();
  return result;
}

}  // namespace seam::claims
