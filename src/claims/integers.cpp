// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/integers.h"

#include <algorithm>
#include <iterator>

#include "claims/parameters.h"
#include "symbolic/coefficients.h"

// For an integer n >= m the power p^n of a prime p is a number >= p^m, and p^(n+1) is p times
// it: so it is a symbol of its own with that range, one for each prime and each parameter. What
// holds for all values of the symbols holds for the powers. Nothing is ever refuted by them.

namespace seam::claims {
namespace {

using exact::Integer;
using exact::Rational;
using symbolic::Simplex;

constexpr long max_size = 100'000;  // of the bounds of an integer parameter

std::vector<std::pair<long, long>> prime_powers(Integer n, long sign) {
  std::vector<std::pair<long, long>> result;
  for (long p = 2; p <= 1000 && n > 1; ++p) {
    long exponent = 0;
    for (; n % p == 0; n /= p) ++exponent;
    if (exponent > 0) result.emplace_back(p, sign * exponent);
  }
  if (n > 1) throw Unsupported("a power of a number with a prime factor over 1000");
  return result;
}

// The power of a prime with a general exponent, as a symbol.
Scalar prime_power(Evaluator& evaluator, long prime, const std::string& parameter) {
  const std::string name = std::to_string(prime) + "^" + parameter;
  const bool known = std::ranges::any_of(evaluator.parameters,
                                         [&](const Parameter& p) { return p.name == name; });
  if (!known) {
    const Integers::General& range = evaluator.integers.general.at(parameter);
    Simplex set = symbolic::whole_line_right(name, 0, true);
    if (range.first && std::abs(*range.first) <= 1000) {
      const Formula first = power(Scalar(prime), *range.first, evaluator.numbers).numerator;
      set = range.upward ? symbolic::whole_line_right(name, first, false)
                         : symbolic::interval(name, 0, first, true, false);
    }
    evaluator.parameters.push_back({name, set, {}});
  }
  return Scalar(Formula::symbol(name));
}

// constant + sum of multiples of general parameters, all integers.
struct Linear {
  long constant = 0;
  std::map<std::string, long> multiples;
};

std::optional<Linear> linear(Evaluator& evaluator, const Scalar& scalar) {
  if (!scalar.is_polynomial()) return std::nullopt;
  const auto found = symbolic::variables(scalar.numerator);
  const std::vector<std::string> variables(found.begin(), found.end());
  Linear result;
  for (const auto& [exponents, coefficient] :
       symbolic::coefficients(scalar.numerator, variables, evaluator.numbers)) {
    const auto value = evaluator.numbers.rational(coefficient);
    if (!value || value->get_den() != 1 || abs(value->get_num()) > max_size)
      return std::nullopt;
    const long multiple = value->get_num().get_si();
    std::string variable;
    for (std::size_t i = 0; i < variables.size(); ++i) {
      if (exponents[i] == 0) continue;
      if (exponents[i] > 1 || !variable.empty()) return std::nullopt;
      variable = variables[i];
    }
    if (variable.empty())
      result.constant = multiple;
    else if (evaluator.integers.general.contains(variable))
      result.multiples[variable] = multiple;
    else
      return std::nullopt;
  }
  return result;
}

long floor_of(const Rational& x) {
  Integer result;
  mpz_fdiv_q(result.get_mpz_t(), x.get_num_mpz_t(), x.get_den_mpz_t());
  if (abs(result) > max_size) throw Unsupported("an integer parameter with so large a bound");
  return result.get_si();
}

// Takes a bound out of `a n + b relation 0`; false if it says more, or of more.
bool take_bound(IntegerRange& range, const symbolic::Constraint& constraint,
                const std::string& parameter, Evaluator& evaluator) {
  const auto variables = symbolic::variables(constraint.formula);
  if (!constraint.formula.is_polynomial() || variables != std::set<std::string>{parameter})
    return false;
  Rational a, b;
  for (const auto& [exponents, coefficient] :
       symbolic::coefficients(constraint.formula, {parameter}, evaluator.numbers)) {
    const auto value = evaluator.numbers.rational(coefficient);
    if (!value || exponents[0] > 1) return false;
    (exponents[0] == 1 ? a : b) = *value;
  }
  if (a == 0 || constraint.relation == Relation::nonzero) return false;
  const Rational root = -b / a;
  const bool strict =
      constraint.relation == Relation::positive || constraint.relation == Relation::negative;
  const bool greater =
      constraint.relation == Relation::positive || constraint.relation == Relation::nonnegative;
  const bool from_below = constraint.relation == Relation::zero || greater == (a > 0);
  const bool from_above = constraint.relation == Relation::zero || greater != (a > 0);
  if (from_below) {
    const long bound = strict ? floor_of(root) + 1 : -floor_of(-root);
    range.low = std::max(range.low.value_or(bound), bound);
  }
  if (from_above) {
    const long bound = strict ? -floor_of(-root) - 1 : floor_of(root);
    range.high = std::min(range.high.value_or(bound), bound);
  }
  return true;
}

// What a set says of its members.
std::vector<symbolic::Constraint> bounds(Evaluator& evaluator, const Expression& set,
                                         const std::string& parameter) {
  const Formula n = Formula::symbol(parameter);
  if (set.kind == Expression::Kind::range)
    return {{n - Formula(evaluator.integer(set.children[0], {})), Relation::nonnegative},
            {n - Formula(evaluator.integer(set.children[1], {})), Relation::nonpositive}};
  const Simplex interval = evaluator.continuous_set(set, {parameter}, {});
  std::vector<symbolic::Constraint> result;
  for (std::size_t end = 0; end < 2; ++end) {
    const auto &corner = interval.corners[end], &other = interval.corners[1 - end];
    if (corner[0].is(0)) continue;
    const Formula beyond = other[0].is(0) ? other[1] : other[1] - corner[1];
    const bool is_low = evaluator.numbers.sign(beyond) == exact::Sign::positive;
    const bool is_open = interval.open[1 - end];  // facet i lies opposite corner i
    const Relation above = is_open ? Relation::positive : Relation::nonnegative;
    const Relation below = is_open ? Relation::negative : Relation::nonpositive;
    result.push_back({n - corner[1], is_low ? above : below});
  }
  return result;
}

}  // namespace

Assigned::Assigned(Evaluator& evaluator, const std::string& parameter, Scalar value)
    : evaluator_(evaluator),
      before_(evaluator.integers),
      parameters_(evaluator.parameters.size()) {
  evaluator.integers.values[parameter] = std::move(value);
  evaluator.integers.lets.clear();
  // What a sequence is at a number does not change.
  std::erase_if(evaluator.integers.steps,
                [](const auto& step) { return !step.first.second.starts_with("+"); });
}

Assigned::~Assigned() {
  evaluator_.integers = std::move(before_);
  evaluator_.parameters.resize(parameters_);
}

std::optional<Index> as_index(Evaluator& evaluator, const Scalar& scalar) {
  const auto sum = linear(evaluator, scalar);
  if (!sum || sum->multiples.size() > 1) return std::nullopt;
  if (sum->multiples.empty()) return Index{{}, sum->constant};
  const auto& [parameter, multiple] = *sum->multiples.begin();
  if (multiple != 1) return std::nullopt;
  return Index{parameter, sum->constant};
}

void generalise(Evaluator& evaluator, const std::string& parameter, Integers::General range) {
  const Formula first(range.first.value_or(0));
  std::optional<Simplex> set;
  if (range.first)
    set = range.upward ? symbolic::whole_line_right(parameter, first, false)
                       : symbolic::whole_line_left(parameter, first, false);
  evaluator.parameters.push_back({parameter, set, {}});
  evaluator.integers.general[parameter] = range;
  evaluator.integers.values[parameter] = Scalar(Formula::symbol(parameter));
}

bool holds_integer(const Evaluator& evaluator, const Scalar& value) {
  const Integers& integers = evaluator.integers;
  std::set<std::string> held = symbolic::variables(value.numerator);
  held.merge(symbolic::variables(value.denominator));
  return std::ranges::any_of(held, [&](const std::string& name) {
    return integers.general.contains(name) || integers.opaque.contains(name) ||
           name.find('^') != std::string::npos;
  });
}

Scalar integer_value(Evaluator& evaluator, const std::string& parameter) {
  Integers& integers = evaluator.integers;
  if (const auto found = integers.values.find(parameter); found != integers.values.end())
    return found->second;
  if (!integers.relaxed) throw IntegerMet(parameter);
  const IntegerRange range = integer_range(evaluator, parameter);
  generalise(
      evaluator, parameter,
      range.low ? Integers::General{range.low, true} : Integers::General{range.high, false});
  Parameter& added = evaluator.parameters.back();
  added.where = range.rest;
  if (range.low && range.high)
    added.where.push_back(
        {Formula::symbol(parameter) - Formula(*range.high), Relation::nonpositive});
  for (const std::string& other : range.others) integer_value(evaluator, other);
  return integers.values.at(parameter);
}

std::optional<Scalar> integer_power(Evaluator& evaluator, const Scalar& base,
                                    const Scalar& exponent) {
  const auto sum = linear(evaluator, exponent);
  if (!sum || sum->multiples.empty()) return std::nullopt;
  const auto number = is_number(base) ? evaluator.numbers.rational(formula_of(base))
                                      : std::optional<Rational>();
  if (!number || *number <= 0)
    throw Unsupported(
        "an integer parameter as the exponent of anything but a positive rational number");
  auto primes = prime_powers(number->get_num(), 1);
  const auto below = prime_powers(number->get_den(), -1);
  primes.insert(primes.end(), below.begin(), below.end());
  Scalar result = power(base, sum->constant, evaluator.numbers);
  for (const auto& [prime, times] : primes)
    for (const auto& [parameter, multiple] : sum->multiples)
      result = result * power(prime_power(evaluator, prime, parameter), times * multiple,
                              evaluator.numbers);
  return result;
}

IntegerRange integer_range(Evaluator& evaluator, const std::string& parameter) {
  const Item& item = *evaluator.integers.known.at(parameter);
  const Assigned symbol(evaluator, parameter, Scalar(Formula::symbol(parameter)));
  std::set<std::string> unassigned;
  for (const std::string& name : item.names)
    if (evaluator.integers.values.try_emplace(name, Formula::symbol(name)).second)
      unassigned.insert(name);

  std::vector<symbolic::Constraint> all;
  if (!item.expressions.empty()) all = bounds(evaluator, item.expressions[0], parameter);
  if (item.where) {
    Stating stating(evaluator);
    const auto found = stating.constraints(*item.where, {}, {}, true);
    if (!found || !stating.guards.empty())
      fail(*item.where, "a condition after 'where' compares polynomials");
    all.insert(all.end(), found->begin(), found->end());
  }
  IntegerRange range;
  for (const symbolic::Constraint& constraint : all) {
    const auto variables = symbolic::variables(constraint.formula);
    for (const std::string& v : variables)
      if (!evaluator.integers.known.contains(v))
        throw Unsupported("a condition that compares an integer parameter with a real one");
    std::set<std::string> others;
    std::ranges::set_intersection(variables, unassigned, std::inserter(others, others.end()));
    if (variables.empty()) {
      // Of other parameters, which are numbers here: no value meets it, or all do.
      if (!meets(evaluator.numbers.sign(constraint.formula), constraint.relation))
        range.low = 1, range.high = 0;
    } else if (!variables.contains(parameter)) {
      continue;
    } else if (!others.empty()) {
      range.others.merge(others);
    } else if (!take_bound(range, constraint, parameter, evaluator)) {
      range.rest.push_back(constraint);
    }
  }
  return range;
}

}  // namespace seam::claims
