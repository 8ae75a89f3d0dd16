// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "claims/stating.h"

// "solve x: S gives s1, s2": S is a conjunction of equations, perhaps for all values of further
// variables; it becomes one obligation on the system of their differences. Every real number as
// the domain is two rays that meet where no solution is claimed to lie within an interval.

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

struct System {
  std::string unknown;
  std::vector<std::string> for_all;
  std::vector<Formula> equations;
};

class Solving {
 public:
  explicit Solving(Stating& stating) : stating_(stating), evaluator_(stating.evaluator) {}

  void collect(const Expression& e, const Scope& scope, System& system);
  void narrow(const Expression& e, const Scope& scope, const std::string& unknown, Ends& ends);
  Ends ends_of(const Expression& set, const Scope& scope);

 private:
  void equate(const Expression& at, const Value& a, const Value& b, System& system);
  void raise(Ends& ends, const Formula& bound, bool open, bool lower);

  Stating& stating_;
  Evaluator& evaluator_;
};

void Solving::equate(const Expression& at, const Value& a, const Value& b, System& system) {
  if (a.as<Scalar>() && b.as<Scalar>()) {
    for (const Scalar* side : {a.as<Scalar>(), b.as<Scalar>()})
      for (const Formula& divisor : side->divisors)
        if (symbolic::variables(divisor).contains(system.unknown))
          throw Unsupported("an equation with the unknown in a divisor");
    Context context;
    context.lines = system.for_all;
    system.equations.push_back(
        stating_.compared(*a.as<Scalar>(), "=", *b.as<Scalar>(), context, at).formula);
    return;
  }
  const auto left = as_items(evaluator_, a, at), right = as_items(evaluator_, b, at);
  if (left.size() != right.size()) fail(at, "these sides differ in size");
  for (std::size_t i = 0; i < left.size(); ++i) equate(at, left[i], right[i], system);
}

void Solving::collect(const Expression& e, const Scope& scope, System& system) {
  switch (e.kind) {
    case Kind::conjunction:
      collect(e.children[0], scope, system);
      collect(e.children[1], scope, system);
      return;
    case Kind::relation:
      if (e.text != "=") break;
      equate(e, evaluator_.evaluate(e.children[0], scope),
             evaluator_.evaluate(e.children[1], scope), system);
      return;
    case Kind::for_all: {
      Scope inner{&scope, {}};
      for (std::size_t i = 0; i + 1 < e.children.size(); ++i) {
        if (e.children[i].text != "all" || condition_of(e.children[i]))
          throw Unsupported("'solve' with a bounded 'for' inside");
        for (const Expression& name : e.children[i].children[0].children) {
          system.for_all.push_back(evaluator_.bind(name.text));
          inner.values[name.text] = {Scalar(Formula::symbol(system.for_all.back()))};
        }
      }
      collect(e.children.back(), inner, system);
      return;
    }
    case Kind::call: {
      const auto found = evaluator_.globals.find(e.children[0].text);
      if (found == evaluator_.globals.end() || !found->second.item ||
          found->second.item->kind != Item::Kind::define)
        break;
      const Item& item = *found->second.item;
      if (item.parameters.size() + 1 != e.children.size()) fail(e, "wrong number of arguments");
      Scope inner;
      for (std::size_t i = 0; i < item.parameters.size(); ++i)
        inner.values[item.parameters[i]] = evaluator_.evaluate(e.children[i + 1], scope);
      collect(item.expressions[0], inner, system);
      return;
    }
    default:
      break;
  }
  throw Unsupported("'solve' is covered for equations, 'and', and 'for all' only");
}

void Solving::raise(Ends& ends, const Formula& bound, bool open, bool lower) {
  auto& end = lower ? ends.low : ends.high;
  auto& is_open = lower ? ends.open_low : ends.open_high;
  if (end) {
    const auto sign = evaluator_.numbers.sign(lower ? bound - *end : *end - bound);
    if (sign == exact::Sign::negative || (sign == exact::Sign::zero && is_open)) return;
  }
  end = bound;
  is_open = open;
}

// A condition on the unknown: comparisons of the unknown itself with numbers.
void Solving::narrow(const Expression& e, const Scope& scope, const std::string& unknown,
                     Ends& ends) {
  if (e.kind == Kind::conjunction) {
    narrow(e.children[0], scope, unknown, ends);
    narrow(e.children[1], scope, unknown, ends);
    return;
  }
  const bool one = e.kind == Kind::relation && e.children.size() == 2;
  if (!one || (e.text != "<" && e.text != "<=" && e.text != ">" && e.text != ">="))
    throw Unsupported("a condition of 'solve' other than a bound for the unknown");
  const Scalar left = evaluator_.scalar(e.children[0], scope),
               right = evaluator_.scalar(e.children[1], scope);
  const auto is_unknown = [&](const Scalar& s) {
    return s.is_polynomial() && s.numerator.kind() == Formula::Kind::symbol &&
           s.numerator.name() == unknown;
  };
  const bool open = e.text.size() == 1, greater = e.text[0] == '>';
  if (is_unknown(left) && is_number(right)) return raise(ends, right.numerator, open, greater);
  if (is_unknown(right) && is_number(left)) return raise(ends, left.numerator, open, !greater);
  throw Unsupported("a condition of 'solve' other than a bound for the unknown");
}

Ends Solving::ends_of(const Expression& set, const Scope& scope) {
  const Simplex simplex = evaluator_.continuous_set(set, {"~"}, scope);
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

}  // namespace

Proposition Stating::solved(const Expression& e, const Scope& scope, const Context& context) {
  const auto& unknowns = e.children[0].children;
  if (unknowns.size() != 1)
    throw Unsupported("'solve' with several unknowns is not covered yet");
  const bool bounded = unknowns[0].kind == Kind::binding;
  const auto& names = bounded ? unknowns[0].children[0].children : unknowns;
  if (names.size() != 1) throw Unsupported("'solve' with several unknowns is not covered yet");

  Solving solving(*this);
  System system;
  system.unknown = evaluator.bind(names[0].text);
  Scope inner{&scope, {}};
  inner.values[names[0].text] = {Scalar(Formula::symbol(system.unknown))};
  Ends ends;
  if (bounded && set_of(unknowns[0])) ends = solving.ends_of(*set_of(unknowns[0]), scope);
  for (const Expression& condition : e.children[2].children)
    solving.narrow(condition, inner, system.unknown, ends);
  if (const Expression* condition = bounded ? condition_of(unknowns[0]) : nullptr)
    solving.narrow(*condition, inner, system.unknown, ends);
  if (ends.low && ends.high &&
      evaluator.numbers.sign(*ends.high - *ends.low) != exact::Sign::positive)
    throw Unsupported("'solve' on an empty domain, or on one of a single point");
  solving.collect(e.children[1], inner, system);
  for (const Formula& f : system.equations)
    for (const std::string& v : symbolic::variables(f))
      if (v != system.unknown && std::ranges::find(system.for_all, v) == system.for_all.end())
        throw Unsupported("'solve' with the parameter '" + v + "' is not covered yet");

  std::vector<Formula> exact;
  std::vector<std::pair<Rational, Rational>> near;
  std::vector<Proposition> parts;
  for (const Expression& solution : e.children[3].children) {
    if (e.text == "one") {
      near.push_back(printed_range(solution));
      continue;
    }
    const Value value = evaluator.evaluate(solution, scope);
    const Formula number = value.as<Vector>() && value.as<Vector>()->size() == 1
                               ? as_number(evaluator, {value.as<Vector>()->front()}, solution)
                               : as_number(evaluator, value, solution);
    for (const Formula& other : exact)
      if (evaluator.numbers.equal(other, number))
        fail(solution, "this solution is given twice");
    exact.push_back(number);
    if (ends.low)
      parts.push_back(holds(number - *ends.low,
                            ends.open_low ? Relation::positive : Relation::nonnegative, context,
                            solution, "the solution lies in the domain"));
    if (ends.high)
      parts.push_back(holds(*ends.high - number,
                            ends.open_high ? Relation::positive : Relation::nonnegative,
                            context, solution, "the solution lies in the domain"));
  }

  if (e.text == "one" && near.empty())
    throw Unsupported("'gives one' without a printed value ('gives one ~ 0.617')");
  const Formula cut = near.empty() ? Formula(0) : Formula(Rational(near.front().first - 1));
  for (const Simplex& piece : pieces(ends, system.unknown, cut)) {
    symbolic::Solutions solutions{
        system.equations, system.unknown, system.for_all, piece, {}, {}};
    const bool halves = !ends.low && !ends.high, left = halves && piece.corners[1][1].is(-1);
    for (const Formula& number : exact) {
      const bool on_left = evaluator.numbers.sign(number - cut) != exact::Sign::positive;
      if (!halves || on_left == left) solutions.exact.push_back(number);
    }
    if (!left) solutions.near = near;
    parts.push_back(symbolic::atom(std::move(solutions), "these solutions and no other"));
  }
  evaluator.release(system.unknown);
  for (const std::string& symbol : system.for_all) evaluator.release(symbol);
  return symbolic::all(std::move(parts));
}

}  // namespace seam::claims
