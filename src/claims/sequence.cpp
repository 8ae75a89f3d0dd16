// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "claims/stating.h"
#include "symbolic/formula.h"

// At a number a sequence is worked out from its start on. At an integer parameter n its value
// is not known: a symbol for each entry, of which only the step to n + 1 is used, or what an
// induction has shown of it. Sums up to n are such values too.
//
// Such a symbol does not show what it depends on. So nothing may be derived by, or put in for,
// a parameter that a sequence or a sum holds, and no other variable may stand in them.

namespace seam::claims {
namespace {

constexpr long max_index = 1000;
constexpr std::size_t max_key = 10'000;

// A real number that is not known, or what is known of it.
Scalar unknown(Evaluator& evaluator, const std::string& name) {
  Integers& integers = evaluator.integers;
  if (const auto found = integers.replaced.find(name); found != integers.replaced.end())
    return found->second;
  if (integers.opaque.insert(name).second) evaluator.parameters.push_back({name, {}, {}});
  return Scalar(Formula::symbol(name));
}

// Notes the parameters that a value holds, beside integers and unknown values.
void hide(Evaluator& evaluator, const Scalar& value, const std::string& what) {
  std::set<std::string> held;
  for (const Formula& f : {value.numerator, value.denominator})
    held.merge(symbolic::variables(f));
  for (const std::string& name : held) {
    if (evaluator.integers.general.contains(name) || evaluator.integers.opaque.contains(name))
      continue;
    const bool is_parameter = std::ranges::any_of(
        evaluator.parameters, [&](const Parameter& p) { return p.name == name; });
    if (!is_parameter || evaluator.varied.contains(name))
      throw Unsupported(what + " that holds the variable '" + name + "'");
    evaluator.hidden.insert(name);
  }
}

void hide(Evaluator& evaluator, const Value& value, const std::string& what) {
  if (const auto* scalar = value.as<Scalar>()) hide(evaluator, *scalar, what);
  if (const auto* vector = value.as<Vector>())
    for (const Scalar& entry : *vector) hide(evaluator, entry, what);
}

std::size_t entries(const Value& value, const Expression& at) {
  if (value.as<Scalar>()) return 0;
  if (const auto* vector = value.as<Vector>()) return vector->size();
  fail(at, "a value of a sequence is a number or a vector, found " + description(value));
}

class Steps {
 public:
  Steps(Evaluator& evaluator, const Item& item) : evaluator_(evaluator), item_(item) {}

  Value at(long index) {
    for (long k = 0; k < index; ++k) at(Index{{}, k});
    return at(Index{{}, index});
  }
  Value at(const Index& index) {
    const auto key = std::pair(&item_, index.parameter + "+" + std::to_string(index.shift));
    if (const auto found = evaluator_.integers.steps.find(key);
        found != evaluator_.integers.steps.end())
      return found->second;
    return evaluator_.integers.steps[key] = worked_out(index);
  }

 private:
  Value worked_out(const Index& index) {
    if (index.shift == 0)
      return index.parameter.empty() ? checked(0, {}) : symbols(index.parameter);
    Scalar before(index.shift - 1);
    if (!index.parameter.empty()) before = before + Scalar(Formula::symbol(index.parameter));
    Scope scope;
    scope.values[item_.parameters[0]] = {before};
    const Value result = checked(1, scope);
    if (entries(result, item_.expressions[1]) != entries(at(Index{}), item_.expressions[0]))
      fail(item_.expressions[1],
           "a step gives what the start is, a number or as long a vector");
    return result;
  }

  Value checked(std::size_t part, const Scope& scope) {
    const Expression& e = item_.expressions[part];
    const std::size_t before = evaluator_.sides.size();
    Value value = evaluator_.evaluate(e, scope);
    if (const auto* list = value.as<List>(); list && !list->items.empty())
      value = {as_vector(evaluator_, value, e)};
    entries(value, e);
    if (evaluator_.sides.size() > before)
      throw Unsupported("a sequence of values that had to be looked for");
    return value;
  }

  Value symbols(const std::string& parameter) {
    const std::string name = item_.name + "[" + parameter + "]";
    const std::size_t size = entries(at(Index{}), item_.expressions[0]);
    if (size == 0) return {unknown(evaluator_, name)};
    Vector vector;
    for (std::size_t i = 1; i <= size; ++i)
      vector.push_back(unknown(evaluator_, name + "[" + std::to_string(i) + "]"));
    return {vector};
  }

  Evaluator& evaluator_;
  const Item& item_;
};

// As long as it lives, the sequence is among those of which a step is taken.
class Stepping {
 public:
  Stepping(std::set<const Item*>& all, const Item* item)
      : all_(all), item_(item), is_first_(all.insert(item).second) {}
  Stepping(const Stepping&) = delete;
  Stepping& operator=(const Stepping&) = delete;
  ~Stepping() {
    if (is_first_) all_.erase(item_);
  }
  bool is_first() const { return is_first_; }

 private:
  std::set<const Item*>& all_;
  const Item* item_;
  bool is_first_;
};

}  // namespace

Value sequence_value(Evaluator& evaluator, const Item& item, const Scalar& index,
                     const Expression& at) {
  const auto place = as_index(evaluator, index);
  Steps steps(evaluator, item);
  if (!place) fail(at, "a sequence has values at the integers from 0 on");
  if (place->parameter.empty()) {
    if (place->shift < 0) fail(at, "a sequence begins at 0");
    if (place->shift > max_index) throw Unsupported("a sequence so far from its start");
    return steps.at(place->shift);
  }
  const Integers::General& range = evaluator.integers.general.at(place->parameter);
  if (!range.upward || range.first.value_or(-1) < 0)
    throw Unsupported("a sequence at an integer parameter that may be negative");
  if (place->shift < 0 || place->shift > max_index)
    throw Unsupported(
        "a sequence before an integer parameter, at n - 1; at n + 1 it is covered");
  // Not within a step of its own, which asks for the value before it.
  if (const Stepping once(evaluator.integers.stepping, &item); once.is_first())
    for (const Value& value : {steps.at(Index{}), steps.at(Index{place->parameter, 1})})
      hide(evaluator, value, "a sequence");
  return steps.at(*place);
}

std::optional<Value> sum_to_parameter(Evaluator& evaluator, const Expression& each,
                                      const Scope& scope) {
  if (each.kind != Expression::Kind::each || each.children.size() != 2) return std::nullopt;
  const Expression& binding = each.children[1];
  const Expression* set = set_of(binding);
  if (!set || set->kind != Expression::Kind::range || condition_of(binding) ||
      binding.children[0].children.size() != 1)
    return std::nullopt;
  const auto high = as_index(evaluator, evaluator.scalar(set->children[1], scope));
  if (!high || high->parameter.empty()) return std::nullopt;
  const long low = evaluator.integer(set->children[0], scope);
  const Integers::General& range = evaluator.integers.general.at(high->parameter);
  // Below low - 1 the sum stays 0, and a step back would not give it.
  if (!range.upward || !range.first || *range.first + std::min(high->shift, 0L) < low - 1)
    throw Unsupported("a sum up to an integer parameter that may be below its start");
  if (std::labs(high->shift) > max_index) throw Unsupported("a sum so far from a parameter");

  const std::string& name = binding.children[0].children[0].text;
  const auto term = [&](const Scalar& i) {
    Scope inner{&scope, {}};
    inner.values[name] = {i};
    return evaluator.scalar(each.children[0], inner);
  };
  // The general term says which sum it is.
  const std::string symbol = evaluator.bind(name);
  evaluator.integers.general[symbol] = {low, true};
  const Scalar general = term(Scalar(Formula::symbol(symbol)));
  hide(evaluator, general, "a sum up to an integer parameter");
  const std::string key = symbolic::text(general.numerator, max_key) + " / " +
                          symbolic::text(general.denominator, max_key);
  evaluator.integers.general.erase(symbol);
  evaluator.release(symbol);
  if (key.size() >= max_key) throw Unsupported("a sum of so long a formula");
  const std::string what = "sum of " + key + " for " + symbol + " from " + std::to_string(low);
  const auto number = evaluator.sums.emplace(what, evaluator.sums.size() + 1).first->second;
  Scalar total =
      unknown(evaluator, "sum~" + std::to_string(number) + "[" + high->parameter + "]");
  const Scalar n(Formula::symbol(high->parameter));
  for (long k = 1; k <= high->shift; ++k) total = total + term(n + Scalar(k));
  for (long k = high->shift + 1; k <= 0; ++k) total = total - term(n + Scalar(k));
  return Value{total};
}

}  // namespace seam::claims
