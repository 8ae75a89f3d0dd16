// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <functional>

#include "claims/builtin.h"

// Where a number is chosen by a comparison (abs, floor), the value rests on the
// comparison as a fact, so that the checker decides it again.

namespace seam::claims {
namespace {

using symbolic::Fact;

// f of a number or function; on a patch, point by point.
Value of_scalar(const Call& call, const std::function<Scalar(const Scalar&)>& f) {
  const Value value = call.value(0);
  if (const auto* field = value.as<Field>(); field && field->components.size() == 1)
    return {Field{field->shape, {f(field->components[0])}}};
  return {f(as_scalar(call.evaluator, value, call[0]))};
}

Value root_of(const Call& call, int n) {
  return of_scalar(call,
                   [&](const Scalar& x) { return nth_root(x, n, call.evaluator.numbers); });
}

Value sqrt(const Call& call) {
  return root_of(call, 2);
}
Value cbrt(const Call& call) {
  return root_of(call, 3);
}
Value root_n(const Call& call) {
  const long n = call.integer(1);
  if (n < 2 || n > 60) fail(call[1], "expected a root index from 2 to 60");
  return root_of(call, static_cast<int>(n));
}

Formula absolute(const Call& call, const Value& value) {
  const Formula x = as_number(call.evaluator, value, call[0]);
  const bool negative = call.evaluator.numbers.sign(x) == exact::Sign::negative;
  const Formula size = negative ? -x : x;
  return Formula::known(size, {{size, Fact::Relation::nonnegative}});
}

Value abs(const Call& call) {
  return of_scalar(call, [&](const Scalar& x) {
    return is_number(x) ? Scalar(absolute(call, {x}))
                        : claims::absolute(x, call.evaluator.numbers);
  });
}

// The integer n with n <= x < n + 1.
Formula floor_of(const Call& call, const Formula& x) {
  const auto [low, high] = call.evaluator.numbers.enclosure(x, exact::Rational(1, 4));
  exact::Integer n;
  mpz_fdiv_q(n.get_mpz_t(), high.get_num_mpz_t(), high.get_den_mpz_t());
  const auto at_least = [&](const exact::Integer& bound) {
    return call.evaluator.numbers.sign(x - Formula(exact::Rational(bound))) !=
           exact::Sign::negative;
  };
  if (!at_least(n)) n -= 1;
  const Formula below = x - Formula(exact::Rational(n));
  const Formula above = Formula(exact::Rational(exact::Integer(n + 1))) - x;
  return Formula::known(Formula(exact::Rational(n)), {{below, Fact::Relation::nonnegative},
                                                      {above, Fact::Relation::nonnegative},
                                                      {above, Fact::Relation::nonzero}});
}

Value floor(const Call& call) {
  return {Scalar(floor_of(call, call.number(0)))};
}
Value ceil(const Call& call) {
  return {Scalar(-floor_of(call, -call.number(0)))};
}

Value binomial(const Call& call) {
  const long n = call.integer(0), k = call.integer(1);
  if (n < 0 || n > 10000) fail(call[0], "expected an integer from 0 to 10000");
  if (k < 0 || k > n) return {Scalar(0)};
  exact::Integer value;
  mpz_bin_uiui(value.get_mpz_t(), n, k);
  return {Scalar(Formula(exact::Rational(value)))};
}

Value factorial(const Call& call) {
  const long n = call.integer(0);
  if (n < 0 || n > 10000) fail(call[0], "expected an integer from 0 to 10000");
  exact::Integer value;
  mpz_fac_ui(value.get_mpz_t(), n);
  return {Scalar(Formula(exact::Rational(value)))};
}

Value folded(const Call& call, const char* operation, long start) {
  const std::vector<Value> items = items_of_argument(call);
  if (items.empty()) return {Scalar(start)};
  Value result = items[0];
  for (std::size_t i = 1; i < items.size(); ++i)
    result = arithmetic(call.evaluator, call.at, operation, result, items[i]);
  return result;
}

Value sum(const Call& call) {
  if (auto known = sum_to_parameter(call.evaluator, call[0], call.scope)) return *known;
  return folded(call, "+", 0);
}
Value product(const Call& call) {
  return folded(call, "*", 1);
}

// Entries of nested lists and vectors, in order: what makes two items different.
void flatten(Evaluator& evaluator, const Value& value, const Expression& at,
             symbolic::Point& into) {
  if (value.as<Scalar>()) {
    into.push_back(as_formula(evaluator, value, at));
  } else {
    for (const Value& item : as_items(evaluator, value, at)) flatten(evaluator, item, at, into);
  }
}

Value count(const Call& call) {
  const Value value = call.value(0);
  const std::vector<Value> items = items_of_argument(call);
  const auto* list = value.as<List>();
  if (list && list->distinct && items.size() > 1) {
    symbolic::Distinct distinct;
    for (const Value& item : items) {
      symbolic::Point entries;
      if (const auto* patch = item.as<geometry::Patch>()) {
        for (const auto& row : patch->rows())
          for (const auto& point : row)
            entries.insert(entries.end(), point.begin(), point.end());
      } else {
        flatten(call.evaluator, item, call.at, entries);
      }
      distinct.tuples.push_back(std::move(entries));
    }
    const auto size = distinct.tuples.front().size();
    if (std::ranges::all_of(distinct.tuples, [&](const auto& t) { return t.size() == size; }))
      call.evaluator.sides.push_back(
          symbolic::atom(std::move(distinct), "all that are counted differ"));
  }
  return {Scalar(static_cast<long>(items.size()))};
}

}  // namespace

std::vector<Value> items_of_argument(const Call& call) {
  if (call[0].kind == Expression::Kind::each)
    return comprehension(call.evaluator, call[0], call.scope);
  return as_items(call.evaluator, call.value(0), call[0]);
}

Formula greatest(Evaluator& evaluator, const std::vector<Formula>& values, bool maximum) {
  const Formula* best = &values.front();
  for (const Formula& value : values) {
    const auto sign = evaluator.numbers.sign(maximum ? value - *best : *best - value);
    if (sign == exact::Sign::positive) best = &value;
  }
  std::vector<Fact> facts;
  for (const Formula& value : values)
    if (&value != best)
      facts.push_back({maximum ? *best - value : value - *best, Fact::Relation::nonnegative});
  return facts.empty() ? *best : Formula::known(*best, std::move(facts));
}

const Builtins& number_builtins() {
  static const Builtins table = {
      {"sqrt", {1, 1, sqrt}},         {"cbrt", {1, 1, cbrt}},
      {"root_n", {2, 2, root_n}},     {"abs", {1, 1, abs}},
      {"floor", {1, 1, floor}},       {"ceil", {1, 1, ceil}},
      {"binomial", {2, 2, binomial}}, {"factorial", {1, 1, factorial}},
      {"sum", {1, 1, sum}},           {"product", {1, 1, product}},
      {"count", {1, 1, count}}};
  return table;
}

}  // namespace seam::claims
