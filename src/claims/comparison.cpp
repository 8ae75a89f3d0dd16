// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "claims/elementary.h"
#include "claims/parameters.h"
#include "symbolic/approximate.h"
#include "symbolic/atoms.h"
#include "symbolic/denominator.h"

// A comparison of quotients a/b and c/d becomes one of polynomials: (a d - c b) * sign(b d)
// with 0. The sign of a divisor is guessed at one point of the context and stated as a guard
// for all of it, so that nothing rests on the guess. Under constraints the context may fall
// apart into pieces with different signs; there no sign is assumed, and b d is
// multiplied in.

namespace seam::claims {
namespace {

using symbolic::Constraint;
using symbolic::Simplex;

Relation relation_of(const std::string& operation) {
  if (operation == "=") return Relation::zero;
  if (operation == "!=") return Relation::nonzero;
  if (operation == "<") return Relation::negative;
  if (operation == "<=") return Relation::nonpositive;
  if (operation == ">") return Relation::positive;
  return Relation::nonnegative;
}

Relation flipped(Relation relation) {
  switch (relation) {
    case Relation::positive:
      return Relation::negative;
    case Relation::nonnegative:
      return Relation::nonpositive;
    case Relation::nonpositive:
      return Relation::nonnegative;
    case Relation::negative:
      return Relation::positive;
    default:
      return relation;
  }
}

// A line is two halves, each a factor of the domain, where it is one of few; there every way to
// prove is open. One of many stays free.
constexpr std::size_t most_halved = 4;

bool touches(const Simplex& factor, const std::set<std::string>& variables) {
  return std::ranges::any_of(factor.variables,
                             [&](const auto& v) { return variables.contains(v); });
}

bool is_application(const Formula& f, const char* function) {
  return f.kind() == Formula::Kind::applied && f.name() == function;
}

// Analytic everywhere: 0 on all of a set with inner points only if it is 0 everywhere.
bool is_entire(const Formula& f) {
  symbolic::Atoms atoms;
  atoms.add(f);
  return std::ranges::all_of(atoms.entries(), [](const symbolic::Atoms::Entry& entry) {
    return is_application(entry.formula, "exp") || is_application(entry.formula, "sin") ||
           is_application(entry.formula, "cos");
  });
}

// The variables under the roots of a formula.
std::set<std::string> under_roots(const Formula& f) {
  symbolic::Atoms atoms;
  atoms.add(f);
  std::set<std::string> result;
  for (const auto& entry : atoms.entries()) result.merge(symbolic::variables(entry.formula));
  return result;
}

}  // namespace

Stating::Range Stating::range(const std::set<std::string>& variables, const Context& context,
                              const Expression& at) {
  for (const Constraint& constraint : context.where)
    if (symbolic::variables(constraint.formula).empty())
      throw Unsupported("a condition without variables");
  std::set<std::string> open = variables;
  for (const Constraint& constraint : context.where)
    open.merge(symbolic::variables(constraint.formula));
  Context all = context;
  join_parameters(evaluator, open, all);
  Range result;
  auto& [domain, lines] = result;
  domain.where = all.where;
  std::set<std::string> bound;
  for (const Simplex& factor : all.factors) {
    for (const std::string& v : factor.variables)
      if (bound.contains(v) && variables.contains(v))
        throw Unsupported("a variable that is bound twice");
    if (!touches(factor, open)) continue;
    bound.insert(factor.variables.begin(), factor.variables.end());
    domain.factors.push_back(factor);
    for (const std::string& v : factor.variables) open.erase(v);
  }
  for (const std::string& line : all.lines)
    if (open.erase(line)) lines.push_back(line);
  if (!open.empty())
    fail(at, "the variable '" + *open.begin() + "' is not bound here",
         "say 'for all " + *open.begin() + ":' or where it ranges");
  return result;
}

// Whatever became of the value that a root stands in: where its radicand is negative there is
// nothing to be said.
void Stating::guard_roots(const Formula& f, const Context& context, const Expression& at) {
  symbolic::Atoms atoms;
  atoms.add(f);
  for (const auto& entry : atoms.entries()) {
    const bool is_log = is_application(entry.formula, "log");
    if (entry.formula.kind() != Formula::Kind::root && !is_log) continue;
    const Formula& operand = entry.formula.operands()[0];
    for (const symbolic::Domain& domain : domains(symbolic::variables(operand), context, at))
      guards.push_back(symbolic::atom(
          symbolic::Sign{operand, is_log ? Relation::positive : Relation::nonnegative, domain},
          is_log ? "a logarithm is taken of what is positive"
                 : "the radicand is not negative"));
  }
}

std::vector<symbolic::Domain> Stating::halved(const Range& range) {
  if (range.lines.size() > most_halved) return {range.domain};
  std::vector<symbolic::Domain> domains = {range.domain};
  for (const std::string& line : range.lines) {
    std::vector<symbolic::Domain> halves;
    for (const symbolic::Domain& d : domains) {
      halves.push_back(d);
      halves.back().factors.push_back(symbolic::whole_line_left(line, 0, false));
      halves.push_back(d);
      halves.back().factors.push_back(symbolic::whole_line_right(line, 0, false));
    }
    domains = std::move(halves);
  }
  return domains;
}

std::vector<symbolic::Domain> Stating::domains(const std::set<std::string>& variables,
                                               const Context& context, const Expression& at) {
  const Range all = range(variables, context, at);
  if (all.lines.size() > most_halved)
    throw Unsupported("roots and systems for all values of more than four reals");
  return halved(all);
}

Proposition Stating::holds(const Formula& f, Relation relation, const Context& context,
                           const Expression& at, const std::string& about) {
  const Independent all = independent(f, context);
  Proposition p = holds_for_all(all.formula, relation, all.context, at, about);
  return all.is_exact ? p : sufficient(std::move(p));
}

Proposition Stating::holds_for_all(const Formula& stated, Relation relation,
                                   const Context& context, const Expression& at,
                                   const std::string& about) {
  guard_roots(stated, context, at);
  Range range = this->range(symbolic::variables(stated), context, at);
  Formula f = stated;
  if (!range.domain.where.empty() && !context.functions) simplify(f, range);
  if (relation == Relation::zero && range.domain.where.empty()) {
    if (is_entire(f)) return symbolic::atom(symbolic::Zero{f}, about);
    // A polynomial in a line's variable is 0 everywhere when it is on [0, 1].
    const std::set<std::string> inside = under_roots(f);
    std::erase_if(range.lines, [&](const std::string& line) {
      if (inside.contains(line)) return false;
      range.domain.factors.push_back(symbolic::interval(line, 0, 1));
      return true;
    });
  }
  std::vector<Proposition> parts;
  const bool stays_free = context.functions && !context.is_unconditional();
  const auto all = stays_free ? std::vector<symbolic::Domain>{range.domain} : halved(range);
  for (const symbolic::Domain& d : all)
    parts.push_back(symbolic::atom(symbolic::Sign{f, relation, d}, about));
  return parts.size() == 1 ? parts.front() : symbolic::all(std::move(parts), about);
}

// The sign that the formula seems to have on the context: about that at some point inside.
std::optional<exact::Sign> Stating::likely_sign(const Formula& f, const Context& context) {
  for (const int weight : {1, 2, 3, 5, 8}) {
    std::map<std::string, double> point;
    const auto place = [&](const Simplex& factor) {
      double total = 0;
      std::vector<double> sum(factor.variables.size());
      for (std::size_t c = 0; c < factor.corners.size(); ++c) {
        const double share = c == 0 ? weight : 1;
        const auto coordinate = [&](std::size_t i) {
          return share * evaluator.numbers.approximate(factor.corners[c][i]);
        };
        total += coordinate(0);
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += coordinate(i + 1);
      }
      for (std::size_t i = 0; i < sum.size(); ++i) point[factor.variables[i]] = sum[i] / total;
    };
    for (const Parameter& parameter : evaluator.parameters) {
      if (parameter.set)
        place(*parameter.set);
      else
        point[parameter.name] = weight;
    }
    for (const Simplex& factor : context.factors) place(factor);
    for (const std::string& line : context.lines) point[line] = weight;
    const double value = symbolic::approximate(f, point, evaluator.numbers);
    if (std::abs(value) > 1e-9)
      return value > 0 ? exact::Sign::positive : exact::Sign::negative;
  }
  return std::nullopt;
}

std::optional<exact::Sign> Stating::guard_divisor(const Formula& divisor,
                                                  const Context& context,
                                                  const Expression& at) {
  const Independent all = independent(divisor, context);
  const auto sign =
      context.is_unconditional() ? likely_sign(all.formula, all.context) : std::nullopt;
  const Relation relation = !sign                            ? Relation::nonzero
                            : *sign == exact::Sign::positive ? Relation::positive
                                                             : Relation::negative;
  guards.push_back(holds(divisor, relation, context, at, "the divisor is not 0"));
  return sign;
}

void Stating::guard(const Scalar& value, const Context& context, const Expression& at) {
  for (const Formula& divisor : value.divisors) guard_divisor(divisor, context, at);
  for (const Formula& radicand : value.radicands)
    guards.push_back(
        holds(radicand, Relation::nonnegative, context, at, "the radicand is not negative"));
}

// The sign that each factor of the denominator is stated to have; none where one is not. (Roots
// are not negative, nor 0, for they were divided by.)
std::optional<exact::Sign> Stating::guard_denominator(const Formula& denominator,
                                                      const Context& context,
                                                      const Expression& at) {
  const symbolic::Factors all = symbolic::factors(denominator);
  bool negative = all.constant < 0;
  for (const auto& [factor, exponent] : all.powers) {
    if (exponent % 2 == 0 || factor.kind() == Formula::Kind::root || is_exponential(factor))
      continue;
    const auto sign = guard_divisor(factor, context, at);
    if (!sign) return std::nullopt;
    negative ^= *sign == exact::Sign::negative;
  }
  return negative ? exact::Sign::negative : exact::Sign::positive;
}

namespace {

bool holds_exponential(const Scalar& x) {
  for (const Formula* f : {&x.numerator, &x.denominator})
    for (const auto& [factor, exponent] : symbolic::factors(*f).powers)
      if (is_exponential(factor)) return true;
  return false;
}

}  // namespace

Constraint Stating::compared(const Scalar& a, const std::string& operation, const Scalar& b,
                             const Context& context, const Expression& at) {
  // exp increases: exp(A) R exp(B) is A R B.
  if (holds_exponential(a) || holds_exponential(b)) {
    const auto left = exponent(a, evaluator.numbers), right = exponent(b, evaluator.numbers);
    if (left && right) {
      Constraint of_exponents = related(*left - *right, relation_of(operation), context, at);
      of_exponents.scale.reset();
      return of_exponents;
    }
  }
  return related(a - b, relation_of(operation), context, at);
}

Constraint Stating::related(const Scalar& difference, Relation relation, const Context& context,
                            const Expression& at) {
  guard(difference, context, at);
  if (difference.denominator.is(1) || relation == Relation::zero ||
      relation == Relation::nonzero)
    return {difference.numerator, relation, Formula(1)};
  const Formula& denominator = difference.denominator;
  const auto sign = guard_denominator(denominator, context, at);
  if (!sign)
    return {difference.numerator * denominator, relation, symbolic::power(denominator, 2)};
  if (*sign == exact::Sign::positive) return {difference.numerator, relation, denominator};
  return {difference.numerator, flipped(relation), -denominator};
}

Proposition measured(Proposition p, const symbolic::Constraint& compared,
                     const std::string& unit) {
  for (Proposition& part : p.parts) part = measured(std::move(part), compared, unit);
  if (p.kind != Proposition::Kind::atom) return p;
  if (auto* sign = std::get_if<symbolic::Sign>(&p.atom);
      sign && compared.scale && sign->formula.same(compared.formula))
    sign->measure = {*compared.scale, unit};
  return p;
}

Proposition in_units(Proposition p, const Formula& size, const std::string& unit) {
  for (Proposition& part : p.parts) part = in_units(std::move(part), size, unit);
  if (p.kind != Proposition::Kind::atom) return p;
  if (auto* sign = std::get_if<symbolic::Sign>(&p.atom); sign && !sign->measure.unit.empty())
    sign->measure = {sign->measure.scale * size, unit};
  return p;
}

}  // namespace seam::claims
