// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "claims/solving.h"

// One obligation on the system. Every real number as the domain is two rays that meet where no
// solution is claimed to lie within an interval.

namespace seam::claims {
namespace {

using exact::Rational;
using symbolic::Simplex;
using Kind = Expression::Kind;

// The ends of the domain of the unknown; nothing: no end on that side.
struct Ends {
  std::optional<Formula> low, high;
  bool open_low = false, open_high = false;
};

void raise(const Numbers& numbers, Ends& ends, const Formula& bound, bool open, bool lower) {
  auto& end = lower ? ends.low : ends.high;
  auto& is_open = lower ? ends.open_low : ends.open_high;
  if (end) {
    const auto sign = numbers.sign(lower ? bound - *end : *end - bound);
    if (sign == exact::Sign::negative || (sign == exact::Sign::zero && is_open)) return;
  }
  end = bound;
  is_open = open;
}

// A condition on the unknown as one on its ends: comparisons of the unknown itself with
// numbers. False if it is of another kind.
bool narrow(const Solving& solving, const Expression& e, Ends& ends) {
  if (e.kind == Kind::conjunction)
    return narrow(solving, e.children[0], ends) && narrow(solving, e.children[1], ends);
  const bool one = e.kind == Kind::relation && e.children.size() == 2;
  if (!one || (e.text != "<" && e.text != "<=" && e.text != ">" && e.text != ">="))
    return false;
  Evaluator& evaluator = solving.evaluator();
  const Value a = evaluator.evaluate(e.children[0], solving.scope),
              b = evaluator.evaluate(e.children[1], solving.scope);
  const auto *left = a.as<Scalar>(), *right = b.as<Scalar>();
  if (!left || !right) return false;
  const auto is_unknown = [&](const Scalar& s) {
    return s.is_polynomial() && s.numerator.kind() == Formula::Kind::symbol &&
           s.numerator.name() == solving.unknowns.front();
  };
  const bool open = e.text.size() == 1, greater = e.text[0] == '>';
  if (is_unknown(*left) && is_number(*right))
    raise(evaluator.numbers, ends, right->numerator, open, greater);
  else if (is_unknown(*right) && is_number(*left))
    raise(evaluator.numbers, ends, left->numerator, open, !greater);
  else
    return false;
  return true;
}

Ends ends_of(const Solving& solving, const Expression& set) {
  const Simplex simplex = solving.evaluator().continuous_set(set, {"~"}, solving.scope);
  Ends ends;
  const auto at = [&](std::size_t corner) { return simplex.corners[corner]; };
  const auto infinite = [&](std::size_t corner) { return at(corner)[0].is(0); };
  if (infinite(1)) {
    const bool right = !at(1)[1].is(-1);
    (right ? ends.low : ends.high) = at(0)[1];
    (right ? ends.open_low : ends.open_high) = simplex.open[1];
  } else {
    ends.low = at(0)[1];
    ends.high = at(1)[1];
    ends.open_low = simplex.open[1];
    ends.open_high = simplex.open[0];
  }
  return ends;
}

// The domain as one or two simplices.
std::vector<Simplex> pieces(const Ends& ends, const std::string& unknown, const Formula& cut) {
  if (ends.low && ends.high)
    return {symbolic::interval(unknown, *ends.low, *ends.high, ends.open_low, ends.open_high)};
  if (ends.low) return {symbolic::whole_line_right(unknown, *ends.low, ends.open_low)};
  if (ends.high) return {symbolic::whole_line_left(unknown, *ends.high, ends.open_high)};
  return {symbolic::whole_line_left(unknown, cut, false),
          symbolic::whole_line_right(unknown, cut, true)};
}

// The claimed solutions, as numbers; false if one is of another kind.
bool read_numbers(const Solving& solving, std::vector<Formula>& numbers) {
  Evaluator& evaluator = solving.evaluator();
  for (const Expression& solution : solving.solutions()) {
    const Value value = evaluator.evaluate(solution, solving.scope);
    const auto* tuple = value.as<Vector>();
    const Value entry = tuple && tuple->size() == 1 ? Value{tuple->front()} : value;
    const auto* scalar = entry.as<Scalar>();
    if (scalar && !is_number(*scalar)) return false;
    const Formula number = as_number(evaluator, entry, solution);
    for (const Formula& other : numbers)
      if (evaluator.numbers.equal(other, number))
        fail(solution, "this solution is given twice");
    numbers.push_back(number);
  }
  return true;
}

Proposition in_domain(const Solving& solving, const Formula& number, const Ends& ends,
                      const Expression& solution) {
  const auto lies = [&](const Formula& from_end, bool open) {
    return solving.stating.holds(from_end, open ? Relation::positive : Relation::nonnegative,
                                 solving.around, solution, "the solution lies in the domain");
  };
  std::vector<Proposition> parts;
  if (ends.low) parts.push_back(lies(number - *ends.low, ends.open_low));
  if (ends.high) parts.push_back(lies(*ends.high - number, ends.open_high));
  return symbolic::all(std::move(parts));
}

}  // namespace

std::optional<Proposition> solved_alone(const Solving& solving) {
  if (solving.unknowns.size() != 1 || !solving.around.where.empty()) return std::nullopt;
  const std::string& unknown = solving.unknowns.front();
  for (const Formula& f : solving.equations)
    for (const std::string& v : symbolic::variables(f))
      if (v != unknown && std::ranges::find(solving.for_all, v) == solving.for_all.end())
        return std::nullopt;
  Ends ends;
  if (solving.sets.front()) ends = ends_of(solving, *solving.sets.front());
  for (const Expression* condition : solving.conditions)
    if (!narrow(solving, *condition, ends)) return std::nullopt;
  const Numbers& numbers = solving.evaluator().numbers;
  if (ends.low && ends.high && numbers.sign(*ends.high - *ends.low) != exact::Sign::positive)
    throw Unsupported("'solve' on an empty domain, or on one of a single point");

  const bool is_one = solving.at.text == "one";
  std::vector<Formula> exact;
  std::vector<std::pair<Rational, Rational>> near;
  if (is_one)
    for (const Expression& printed : solving.solutions())
      near.push_back(printed_range(printed));
  else if (!read_numbers(solving, exact))
    return std::nullopt;
  if (is_one && near.empty())
    throw Unsupported("'gives one' without a printed value ('gives one ~ 0.617')");

  std::vector<Proposition> parts;
  for (std::size_t i = 0; i < exact.size(); ++i)
    parts.push_back(in_domain(solving, exact[i], ends, solving.solutions()[i]));
  const Formula cut = near.empty() ? Formula(0) : Formula(Rational(near.front().first - 1));
  for (const Simplex& piece : pieces(ends, unknown, cut)) {
    symbolic::Solutions solutions{solving.equations, unknown, solving.for_all, piece, {}, {}};
    const bool halves = !ends.low && !ends.high, left = halves && piece.corners[1][1].is(-1);
    for (const Formula& number : exact) {
      const bool on_left = numbers.sign(number - cut) != exact::Sign::positive;
      if (!halves || on_left == left) solutions.exact.push_back(number);
    }
    if (!left) solutions.near = near;
    parts.push_back(symbolic::atom(std::move(solutions), "these solutions and no other"));
  }
  return symbolic::all(std::move(parts));
}

}  // namespace seam::claims
