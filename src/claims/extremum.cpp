// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "claims/parameters.h"
#include "claims/triangulation.h"
#include "symbolic/coefficients.h"

// max f <= c: f <= c everywhere. max f >= c: not f < c everywhere. The domains are compact and
// f is continuous, so the maximum is attained.
//
// For all values of parameters, "attained" is an existence statement. It follows where one
// point, the same for all values, has the value; it is refuted where for one value of the
// parameters the extremum is another.

namespace seam::claims {

using symbolic::Constraint;

namespace {

// Products are cut into simplices where a maximum touches the bound within several factors and
// mixes them: no subdivision of the product shows the sign near such a point.
std::vector<symbolic::Domain> pieces(const symbolic::Domain& domain, bool cut) {
  if (!cut || domain.factors.size() < 2) return {domain};
  std::vector<symbolic::Domain> result;
  for (symbolic::Simplex& simplex : triangulated(domain.factors))
    result.push_back({{std::move(simplex)}, domain.where});
  return result;
}

Extremum at_values(const Extremum& extremum, const std::map<std::string, Scalar>& values,
                   Numbers& numbers) {
  Extremum result = extremum;
  for (Extremum::Part& part : result.parts)
    part.value = substitute(part.value, values, numbers);
  return result;
}

// The parameters of the file that occur join what the context has.
Context with_parameters(const Evaluator& evaluator, const Extremum& extremum,
                        const Scalar& bound, const Context& context) {
  std::set<std::string> open = symbolic::variables((bound.numerator * bound.denominator));
  for (const Extremum::Part& part : extremum.parts)
    open.merge(symbolic::variables(part.value.numerator * part.value.denominator));
  Context result = context;
  join_parameters(evaluator, open, result);
  return result;
}

// A point inside all the sets, another one for each weight.
std::map<std::string, Scalar> inner_point(Evaluator& evaluator, const Context& context,
                                          const exact::Rational& weight) {
  std::map<std::string, Scalar> point;
  for (const symbolic::Simplex& factor : context.factors) {
    Formula total = 0;
    symbolic::Point sum(factor.variables.size(), Formula(0));
    for (std::size_t c = 0; c < factor.corners.size(); ++c) {
      const Formula share(c == 0 ? weight : exact::Rational(1));
      total += share * factor.corners[c][0];
      for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += share * factor.corners[c][i + 1];
    }
    const Formula inverse = evaluator.numbers.inverse(total);
    for (std::size_t i = 0; i < sum.size(); ++i)
      point.emplace(factor.variables[i], evaluator.numbers.normal_form(sum[i] * inverse));
  }
  for (const std::string& line : context.lines)
    point.emplace(line, Scalar(Formula(exact::Rational(weight - 2))));
  return point;
}

bool is_identity(const Scalar& difference, const Numbers& numbers) {
  const auto variables = symbolic::variables(difference.numerator);
  return symbolic::coefficients(difference.numerator, {variables.begin(), variables.end()},
                                numbers)
      .empty();
}

}  // namespace

Proposition Stating::sufficient(Proposition p) {
  guards.push_back(p);
  return p;
}

Proposition Stating::refuting(Proposition p) {
  guards.push_back(p);
  return symbolic::negation(std::move(p));
}

void Stating::state_attained(const Expression& at, const Attained& place) {
  const Constraint equal = compared(place.here, "=", Scalar(place.value), {}, at);
  guards.push_back(holds(equal.formula, equal.relation, {}, at, "attained"));
}

Proposition Stating::everywhere(const Expression& at, const Extremum& extremum,
                                const std::string& operation, const Scalar& bound,
                                const Context& context, bool cut) {
  std::vector<Proposition> parts;
  for (const Extremum::Part& part : extremum.parts)
    for (const symbolic::Domain& domain : pieces(part.domain, cut)) {
      Context inner = context;
      inner.factors.insert(inner.factors.end(), domain.factors.begin(), domain.factors.end());
      Context full = inner;
      full.where.insert(full.where.end(), domain.where.begin(), domain.where.end());
      const auto state = [&](const Scalar& value) {
        const Constraint c = compared(value, operation, bound, inner, at);
        parts.push_back(holds(c.formula, c.relation, full, at));
      };
      // |E| <= b says that E <= b and -E <= b.
      const auto inside = inside_absolute(part.value);
      if (inside && (operation == "<" || operation == "<=")) {
        state(*inside);
        state(-*inside);
      } else {
        state(part.value);
      }
    }
  return symbolic::all(std::move(parts));
}

// For all values of the context: somewhere `extremum operation bound`. For "=" it is known
// that nowhere it is exceeded.
Proposition Stating::reached(const Expression& at, const Extremum& extremum,
                             const std::string& operation, const Scalar& bound,
                             const Context& context) {
  Numbers& numbers = evaluator.numbers;
  const std::string below = extremum.maximum ? "<" : ">", above = extremum.maximum ? ">" : "<";
  const auto holds_for = [&](const Formula& difference) {
    const exact::Sign sign = numbers.sign(difference);
    if (sign == exact::Sign::zero) return operation != below && operation != above;
    return operation != "=" && (sign == exact::Sign::positive) == extremum.maximum;
  };
  struct Sample {
    std::map<std::string, Scalar> values;
    Scalar bound;
  };
  const auto candidates = [&](const Extremum& here) -> std::vector<Attained> {
    try {
      return attained(evaluator, here, 8);
    } catch (const Unsupported&) {
      return {};
    }
  };
  const Context full = with_parameters(evaluator, extremum, bound, context);
  std::vector<Sample> samples;
  std::vector<Attained> places;
  for (const exact::Rational& weight :
       {exact::Rational(1), exact::Rational(1, 4), exact::Rational(4), exact::Rational(1, 9)}) {
    Sample sample{inner_point(evaluator, full, weight), 0};
    sample.bound = substitute(bound, sample.values, numbers);
    const Extremum here = at_values(extremum, sample.values, numbers);
    if (!is_number(sample.bound)) throw Unsupported("an extremum compared with a function");
    // A point there may be nearly the best only; so there must be room on either side.
    const Attained near = nearly_attained(evaluator, here, 80);
    const double gap = numbers.approximate(near.value - sample.bound.numerator);
    const double room = 1e-15 * std::max(1.0, std::abs(numbers.approximate(near.value)));
    const bool exceeds = extremum.maximum ? gap > room : gap < -room;
    const bool falls_short = extremum.maximum ? gap < -room : gap > room;
    if (full.where.empty() && exceeds && operation == "=") {
      const Constraint c = compared(near.here, above, sample.bound, {}, at);
      return refuting(holds(c.formula, c.relation, {}, at, "for one value it is exceeded"));
    }
    if (full.where.empty() && falls_short) {
      Proposition p = everywhere(at, here, below, sample.bound, {}, false);
      p.about = "for one value it is not attained";
      return refuting(std::move(p));
    }
    if (samples.empty()) places = candidates(here);
    samples.push_back(std::move(sample));
  }
  for (const Attained& place : places) {
    std::map<std::string, Scalar> point;
    for (const auto& [name, coordinate] : place.point) point.emplace(name, coordinate);
    const Scalar there = substitute(extremum.parts[place.part].value, point, numbers);
    const bool fits = std::ranges::all_of(samples, [&](const Sample& sample) {
      const Scalar difference = substitute(there - bound, sample.values, numbers);
      return is_number(difference) && holds_for(numbers.normal_form(difference.numerator));
    });
    if (!fits || (operation == "=" && !is_identity(there - bound, numbers))) continue;
    const Constraint c = compared(there, operation, bound, context, at);
    return sufficient(holds(c.formula, c.relation, context, at, "attained"));
  }
  throw Unsupported(
      "an extremum that is attained at no point common to all values under 'for all'");
}

Proposition Stating::compare_extremum(const Expression& at, const Extremum& extremum,
                                      const std::string& operation, const Scalar& bound,
                                      const Context& context) {
  const bool max = extremum.maximum;
  const std::string below = max ? "<=" : ">=", strictly_below = max ? "<" : ">";
  if (operation == below || operation == strictly_below)
    return everywhere(at, extremum, operation, bound, context, false);
  const bool equality = operation == "=" || operation == "!=";
  if (!equality) {
    if (!context.empty()) return reached(at, extremum, operation, bound, context);
    return symbolic::negation(
        everywhere(at, extremum, negated_operation(operation), bound, context, false));
  }
  if (operation == "!=" && !context.empty())
    throw Unsupported("an extremum with '!=' under 'for all'");
  const bool cut = context.empty() && is_oblique(evaluator, extremum);
  Proposition bounded = everywhere(at, extremum, below, bound, context, cut);
  bounded.about = max ? "nowhere larger" : "nowhere smaller";
  Proposition attained =
      context.empty()
          ? symbolic::negation(everywhere(at, extremum, strictly_below, bound, context, false))
          : reached(at, extremum, "=", bound, context);
  attained.about = "attained";
  Proposition equal = symbolic::all({std::move(bounded), std::move(attained)});
  return operation == "=" ? equal : symbolic::negation(std::move(equal));
}

}  // namespace seam::claims
