// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "claims/cover.h"
#include "claims/extremum_trials.h"
#include "claims/stating.h"
#include "exact/recognise.h"

// Let M be the largest |E(., v)|. If the values on either side of v are covered by intervals,
// on each of which |E(x, a)| >= M at one point x, then no a does better than v. If for some a
// all |E(., a)| are less than |E(x, v)| at some x, then that a does. Which of the two is stated
// rests on values in doubles; each says its own only. Intervals share their ends, so nothing
// is left out between them.

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

// The values from one on, up to an end or all.
Simplex part_above(const std::string& unknown, const Formula& from,
                   const std::optional<Formula>& end, bool open) {
  return end ? symbolic::interval(unknown, from, *end, false, open)
             : symbolic::whole_line_right(unknown, from, false);
}
Simplex part_below(const std::string& unknown, const Formula& from,
                   const std::optional<Formula>& end, bool open) {
  return end ? symbolic::interval(unknown, *end, from, open, false)
             : symbolic::whole_line_left(unknown, from, false);
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

  // Stretches from v to an end, and the functions of the unknown that they are of: E at these
  // places of `at`, at the corners and centres of all faces, or else at more points.
  struct Side {
    std::vector<Scalar> errors;
    std::vector<Stretch> stretches;
  };
  Side side(const std::vector<Attained>& places, double largest, double v, double end) const {
    for (const auto tried : {centres, trials}) {
      Side result{along(places, tried(evaluator_, {true, question_.errors})), {}};
      std::vector<std::function<double(double)>> functions;
      for (const Scalar& error : result.errors) functions.push_back(in_doubles(error));
      result.stretches = cover(functions, largest, v, end);
      if (!result.stretches.empty()) return result;
    }
    throw Unsupported(
        "'minimax' where no points were found that show that the values on one side do no "
        "better");
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
  std::vector<Scalar> along(const std::vector<Attained>& places,
                            const std::vector<Trial>& tried) const {
    std::vector<Scalar> result;
    const auto add = [&](std::size_t part, const std::map<std::string, Formula>& coordinates) {
      std::map<std::string, Scalar> point;
      for (const auto& [name, coordinate] : coordinates) point.emplace(name, coordinate);
      result.push_back(substitute(question_.errors[part].value, point, evaluator_.numbers));
    };
    for (const Attained& place : places) add(place.part / 2, place.point);
    const Extremum errors{true, question_.errors};
    for (const Trial& trial : tried) add(trial.part, point_of(errors, trial));
    return result;
  }

  // A function of the unknown, in doubles.
  std::function<double(double)> in_doubles(const Scalar& f) const {
    std::map<std::string, double> point;
    for (const std::string& symbol : symbolic::symbols(f.numerator * f.denominator))
      if (symbolic::is_generator(symbol))
        point[symbol] = evaluator_.numbers.approximate(Formula::symbol(symbol));
    return [this, f, point](double a) mutable {
      point[question_.unknown] = a;
      return approximate(f, point, evaluator_.numbers);
    };
  }

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
  // Points for one side, at each of which the error is never less than the largest on a part of
  // it.
  const auto on_side = [&](bool above) {
    const auto& end = above ? range.high : range.low;
    const bool open = above ? range.open_high : range.open_low;
    std::vector<Proposition> shown;
    if (end && numbers.equal(*end, v)) return shown;
    const double to = end ? numbers.approximate(*end) : above ? HUGE_VAL : -HUGE_VAL;
    const auto [errors, stretches] = question.side(
        places, numbers.approximate(largest.numerator), numbers.approximate(v), to);
    Formula from = v;
    for (const Stretch& stretch : stretches) {
      const std::optional<Formula> until =
          stretch.end ? std::optional(Formula(*stretch.end)) : end;
      const bool is_open = !stretch.end && open;
      Context side;
      side.factors = {above ? part_above(minimax.unknown, from, until, is_open)
                            : part_below(minimax.unknown, from, until, is_open)};
      const Scalar& error = errors[stretch.function];
      const Constraint c = compared(stretch.negative ? -error : error, ">=", largest, side, at);
      shown.push_back(holds(c.formula, c.relation, side, at,
                            above ? "at one point the error is not less for larger values"
                                  : "at one point the error is not less for smaller values"));
      if (until) from = *until;
    }
    return shown;
  };
  Proposition bounded = everywhere(at, here, "<=", largest, {}, is_oblique(evaluator, here));
  bounded.about = "nowhere larger";
  state_attained(at, places[0]);
  parts.push_back(std::move(bounded));
  for (const bool above : {true, false})
    for (Proposition& shown : on_side(above)) parts.push_back(std::move(shown));
  return sufficient(symbolic::all(std::move(parts)));
}

}  // namespace seam::claims
