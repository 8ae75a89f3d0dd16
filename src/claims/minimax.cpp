// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>

#include "claims/stating.h"
#include "exact/recognise.h"

// Let M be the largest |E(., v)|. If |E(x, a)| >= M at one point x for all a >= v, and at one,
// perhaps another, for all a <= v, then no a does better than v. If for some a all |E(., a)|
// are less than |E(x, v)| at some x, then that a does. Which of the two is stated rests on
// values in doubles; each says its own only.

namespace seam::claims {

using exact::Rational;
using symbolic::Constraint;
using symbolic::Simplex;

namespace {

constexpr double better = 1e-10;  // relative: what counts as less

// The ends of the set to choose from; none: infinite.
struct Choices {
  std::optional<Formula> low, high;
  bool open_low = false, open_high = false;
};

Choices range_of(const Minimax& question) {
  Choices result;
  if (!question.range) return result;
  const auto& corners = question.range->corners;
  const auto& open = question.range->open;  // facet i is what lies opposite corner i
  const bool bounded = !corners[1][0].is(0);
  if (bounded || corners[1][1].is(1)) {
    result.low = corners[0][1];
    result.open_low = open[1];
  } else {
    result.high = corners[0][1];
    result.open_high = open[1];
  }
  if (bounded) {
    result.high = corners[1][1];
    result.open_high = open[0];
  }
  return result;
}

class Question {
 public:
  Question(Evaluator& evaluator, const Minimax& question)
      : evaluator_(evaluator), question_(question) {}

  // The largest |E|, as a maximum over E and -E.
  Extremum at(const Formula& a) const {
    Extremum result{true, {}};
    for (const Extremum::Part& part : question_.errors) {
      Extremum::Part here = part;
      here.value = substitute(part.value, {{question_.unknown, Scalar(a)}}, evaluator_.numbers);
      result.parts.push_back(here);
      here.value = -here.value;
      result.parts.push_back(std::move(here));
    }
    return result;
  }

  // |E| at a place of `at`, with the sign it has there, as a function of the unknown.
  Scalar along(const Attained& place) const {
    std::map<std::string, Scalar> point;
    for (const auto& [name, coordinate] : place.point) point.emplace(name, coordinate);
    const Scalar there =
        substitute(question_.errors[place.part / 2].value, point, evaluator_.numbers);
    return place.part % 2 == 0 ? there : -there;
  }

  // Numbers in the range at many distances from v, those below it first.
  std::vector<Rational> samples(const Formula& v, const Choices& range) const {
    const Numbers& numbers = evaluator_.numbers;
    const double middle = numbers.approximate(v);
    const double infinity = std::numeric_limits<double>::infinity();
    const double low = range.low ? numbers.approximate(*range.low) : -infinity;
    const double high = range.high ? numbers.approximate(*range.high) : infinity;
    std::vector<Rational> result;
    for (const double side : {-1.0, 1.0}) {
      const double end = side < 0 ? low : high;
      const double room =
          std::isfinite(end) ? std::abs(end - middle) : 4 * std::max(1.0, std::abs(middle));
      for (const double share : {1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.05, 0.1, 0.2,
                                 0.35, 0.5, 0.7, 0.9}) {
        const double a = middle + side * share * room;
        if (a <= low || a >= high || a == middle) continue;
        result.push_back(exact::simplest(Rational(a), Rational(share * room / 16)));
      }
    }
    return result;
  }

 private:
  Evaluator& evaluator_;
  const Minimax& question_;
};

}  // namespace

Proposition Stating::compare_minimax(const Expression& at, const Minimax& minimax,
                                     const std::string& operation, const Scalar& value,
                                     const Context& context) {
  if (operation != "=" && operation != "!=")
    fail(at, "'minimax' is compared with '=' only",
         "it says which value of a parameter is best");
  if (!context.empty() || !is_number(value))
    throw Unsupported("'minimax' with a parameter, or under 'for all'");
  Numbers& numbers = evaluator.numbers;
  const Formula v = numbers.normal_form(value.numerator);
  const auto stated = [&] { return best_choice(at, minimax, v); };
  return operation == "=" ? stated() : symbolic::negation(stated());
}

Proposition Stating::best_choice(const Expression& at, const Minimax& minimax,
                                 const Formula& v) {
  Numbers& numbers = evaluator.numbers;
  const Choices range = range_of(minimax);
  // That a number is among the values to choose from; or else what shows that it is not.
  const auto among = [&](const Formula& a) {
    std::vector<Proposition> inside, outside;
    const auto end = [&](const Formula& room, bool open) {
      const exact::Sign sign = numbers.sign(room);
      if (sign == exact::Sign::positive || (!open && sign == exact::Sign::zero))
        inside.push_back(holds(room, open ? Relation::positive : Relation::nonnegative, {}, at,
                               "among the values to choose from"));
      else
        outside.push_back(holds(room, open ? Relation::nonpositive : Relation::negative, {}, at,
                                "not among the values to choose from"));
    };
    if (range.low) end(a - *range.low, range.open_low);
    if (range.high) end(*range.high - a, range.open_high);
    return std::pair(std::move(inside), std::move(outside));
  };
  auto [parts, outside] = among(v);
  if (!outside.empty()) return refuting(outside.front());

  const Question question(evaluator, minimax);
  const Extremum here = question.at(v);
  const double most = about(evaluator, here);
  const auto samples = question.samples(v, range);

  // A choice that does better?
  double least = most;
  std::optional<Rational> choice;
  for (const Rational& a : samples) {
    const double there = about(evaluator, question.at(Formula(a)));
    if (there >= least || !among(Formula(a)).second.empty()) continue;
    least = there;
    choice = a;
  }
  if (choice && least < most * (1 - better)) {
    const Rational bound =
        exact::simplest(Rational((least + most) / 2), Rational((most - least) / 4));
    const Attained place = nearly_attained(evaluator, here, 80);
    Proposition less =
        everywhere(at, question.at(Formula(*choice)), "<", Scalar(Formula(bound)), {}, false);
    less.about = "with " + choice->get_str() + " the error is less everywhere";
    const Constraint more = compared(place.here, ">=", Scalar(Formula(bound)), {}, at);
    std::vector<Proposition> shown = {
        std::move(less),
        holds(more.formula, more.relation, {}, at, "with the value stated it is not")};
    for (Proposition& inside : among(Formula(*choice)).first)
      shown.push_back(std::move(inside));
    return refuting(symbolic::all(std::move(shown)));
  }

  const std::vector<Attained> places = attained(evaluator, here, 16);
  const Scalar largest(places[0].value);
  // One point for each side at which the error is never less than the largest.
  const auto on_side = [&](bool above) -> Proposition {
    if (above ? range.high && numbers.equal(*range.high, v)
              : range.low && numbers.equal(*range.low, v))
      return symbolic::truth();
    const std::string symbol = minimax.unknown;
    Context side;
    if (above)
      side.factors = {range.high
                          ? symbolic::interval(symbol, v, *range.high, false, range.open_high)
                          : symbolic::whole_line_right(symbol, v, false)};
    else
      side.factors = {range.low
                          ? symbolic::interval(symbol, *range.low, v, range.open_low, false)
                          : symbolic::whole_line_left(symbol, v, false)};
    for (const Attained& place : places) {
      const Scalar error = question.along(place);
      const bool fits = std::ranges::all_of(samples, [&](const Rational& a) {
        if ((numbers.sign(Formula(a) - v) == exact::Sign::positive) != above) return true;
        const Scalar gain =
            substitute(error - largest, {{symbol, Scalar(Formula(a))}}, numbers);
        return numbers.sign(gain.numerator) != exact::Sign::negative;
      });
      if (!fits) continue;
      const Constraint c = compared(error, ">=", largest, side, at);
      return holds(c.formula, c.relation, side, at,
                   above ? "at one point the error is not less for all larger values"
                         : "at one point the error is not less for all smaller values");
    }
    throw Unsupported(
        "'minimax' where no single point shows that the values on one side do no better");
  };
  Proposition bounded = everywhere(at, here, "<=", largest, {}, is_oblique(evaluator, here));
  bounded.about = "nowhere larger";
  Proposition above = on_side(true), below = on_side(false);
  state_attained(at, places[0]);
  parts.push_back(std::move(bounded));
  parts.push_back(std::move(above));
  parts.push_back(std::move(below));
  return sufficient(symbolic::all(std::move(parts)));
}

}  // namespace seam::claims
