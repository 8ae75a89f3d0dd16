// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/evaluate.h"

#include <algorithm>

// Ends: a name refers to what is defined above it or bound around it, so evaluation follows a
// finite order; the number of steps of one file and the depth of calls are bounded besides.

namespace seam::claims {
namespace {

constexpr long max_steps = 20'000'000;
constexpr int max_depth = 400;

using Kind = Expression::Kind;

const Value* bound(const Scope& scope, const std::string& name) {
  for (const Scope* s = &scope; s; s = s->outer)
    if (const auto found = s->values.find(name); found != s->values.end())
      return &found->second;
  return nullptr;
}

Vector at_parameters(Evaluator& evaluator, const std::vector<Scalar>& components,
                     const std::map<std::string, Scalar>& parameters) {
  Vector result;
  for (const Scalar& component : components)
    result.push_back(substitute(component, parameters, evaluator.numbers));
  return result;
}

Value vector_or_scalar(Vector components) {
  if (components.size() == 1) return {components.front()};
  return {components};
}

std::vector<Scalar> scalars(const symbolic::Point& point, Numbers& numbers) {
  std::vector<Scalar> result;
  for (const Formula& entry : point) result.push_back(scalar_of(entry, numbers));
  return result;
}

}  // namespace

std::string Evaluator::bind(const std::string& name) {
  std::string symbol = name;
  for (int k = 1; active_.contains(symbol); ++k) symbol = name + "~" + std::to_string(k);
  active_.insert(symbol);
  return symbol;
}

Value Evaluator::evaluate(const Expression& e, const Scope& scope) {
  if (++steps_ > max_steps) fail(e, "this file asks for too many steps");
  if (depth_ >= max_depth) fail(e, "this is nested too deeply");
  struct Level {
    int& depth;
    explicit Level(int& d) : depth(d) { ++depth; }
    ~Level() { --depth; }
  } level(depth_);
  try {
    switch (e.kind) {
      case Kind::number:
        return {Scalar(Formula(decimal(e.text)))};
      case Kind::name:
        return name(e, scope);
      case Kind::negate:
        return negated(*this, e, evaluate(e.children[0], scope));
      case Kind::binary: {
        // A long chain leans to the left: walk it without recursion.
        std::vector<const Expression*> chain;
        const Expression* first = &e;
        for (; first->kind == Kind::binary; first = &first->children[0]) chain.push_back(first);
        Value value = evaluate(*first, scope);
        for (auto link = chain.rbegin(); link != chain.rend(); ++link) {
          const Value right = evaluate((*link)->children[1], scope);
          try {
            value = arithmetic(*this, **link, (*link)->text, value, right);
          } catch (const symbolic::NumberError& error) {
            fail(**link, error.what());
          }
        }
        return value;
      }
      case Kind::call:
        return call(e, scope);
      case Kind::index:
        return index(e, scope);
      case Kind::tuple: {
        Vector entries;
        List items;
        for (const Expression& child : e.children) {
          Value value = evaluate(child, scope);
          if (value.as<Extremum>()) value = resolved(value, child);
          if (value.as<Scalar>()) entries.push_back(*value.as<Scalar>());
          items.items.push_back(std::move(value));
        }
        if (entries.size() == items.items.size()) return {entries};
        return {items};
      }
      case Kind::list:
      case Kind::range:
        return list(e, scope);
      case Kind::matrix:
        return matrix(e, scope);
      case Kind::plane: {
        const Vector normal = as_vector(*this, evaluate(e.children[0], scope), e.children[0]);
        return {Plane{normal, scalar(e.children[1], scope)}};
      }
      case Kind::patch:
      case Kind::indexed:
      case Kind::from:
        return net(e, scope);
      case Kind::infinity:
        fail(e, "'infinity' is no number; it may bound an interval");
      case Kind::string:
        fail(e, "a text is no value");
      case Kind::read:
        throw Unsupported("nets from files are not covered yet");
      case Kind::limit:
        throw Unsupported("limits are not covered yet");
      default:
        fail(e, "expected a value, found a statement");
    }
  } catch (const symbolic::NumberError& error) {
    fail(e, error.what());
  } catch (const symbolic::FormulaLimit& error) {
    fail(e, error.what());
  } catch (const symbolic::NumberLimit& error) {
    throw Unsupported(error.what());
  }
}

// Of numbers; of points it is a net, the list of its rows.
Value Evaluator::matrix(const Expression& e, const Scope& scope) {
  MatrixValue numbers_only;
  List net;
  for (const Expression& row : e.children) {
    List points;
    Vector entries;
    for (const Expression& entry : row.children) {
      Value value = evaluate(entry, scope);
      if (value.as<Vector>())
        points.items.push_back(std::move(value));
      else
        entries.push_back(as_scalar(*this, value, entry));
    }
    if (!points.items.empty() && !entries.empty())
      fail(row, "a row of numbers and points", "a matrix has numbers, a net has points");
    const List& first = net.items.empty() ? points : *net.items.front().as<List>();
    if (points.items.size() != first.items.size() ||
        (!numbers_only.rows.empty() && entries.size() != numbers_only.rows.front().size()))
      fail(row, "this row has " + std::to_string(row.children.size()) +
                    " entries, the first has " + std::to_string(e.children[0].children.size()));
    numbers_only.rows.push_back(std::move(entries));
    net.items.push_back({std::move(points)});
  }
  if (net.items.front().as<List>()->items.empty()) return {numbers_only};
  return {net};
}

Scalar Evaluator::scalar(const Expression& e, const Scope& scope) {
  return as_scalar(*this, evaluate(e, scope), e);
}
Formula Evaluator::number(const Expression& e, const Scope& scope) {
  return as_number(*this, evaluate(e, scope), e);
}
long Evaluator::integer(const Expression& e, const Scope& scope) {
  return as_integer(*this, evaluate(e, scope), e);
}

Value Evaluator::name(const Expression& e, const Scope& scope) {
  if (const Value* value = bound(scope, e.text)) return *value;
  if (const auto found = globals.find(e.text); found != globals.end()) {
    const Definition& definition = found->second;
    if (definition.broken) throw Broken();
    if (!definition.unsupported.empty())
      throw Unsupported(definition.unsupported, definition.reason);
    if (definition.holds_integers) return with_integers(e.text, *definition.item);
    sides.insert(sides.end(), definition.sides.begin(), definition.sides.end());
    if (definition.value) return *definition.value;
    return {Function{definition.item}};
  }
  if (auto word = builtin_word(*this, e.text)) return *word;
  const std::string near = text::nearest(e.text, names(scope));
  fail(e, "unknown name '" + e.text + "'", near.empty() ? "" : "did you mean '" + near + "'?");
}

// A value that rests on integer parameters is worked out once for each of their values.
Value Evaluator::with_integers(const std::string& name, const Item& item) {
  if (item.kind == Item::Kind::param) return {integer_value(*this, name)};
  auto found = integers.lets.find(name);
  if (found == integers.lets.end()) {
    std::vector<symbolic::Proposition> around = std::move(sides);
    sides.clear();
    Value value = evaluate(item.expressions[0], Scope{});
    found =
        integers.lets.emplace(name, Integers::Kept{std::move(value), std::move(sides)}).first;
    sides = std::move(around);
  }
  sides.insert(sides.end(), found->second.sides.begin(), found->second.sides.end());
  return found->second.value;
}

std::vector<std::string> Evaluator::names(const Scope& scope) const {
  std::vector<std::string> all = builtin_names();
  for (const Scope* s = &scope; s; s = s->outer)
    for (const auto& entry : s->values) all.push_back(entry.first);
  for (const auto& entry : globals) all.push_back(entry.first);
  return all;
}

Value Evaluator::call(const Expression& e, const Scope& scope) {
  const Expression& callee = e.children[0];
  if (callee.kind == Kind::name && !bound(scope, callee.text) && !globals.contains(callee.text))
    if (auto value = builtin(*this, callee.text, e, scope)) return *value;
  return apply(evaluate(callee, scope), e, scope);
}

// A value with arguments behind it: a point of a patch or a curve, a function.
Value Evaluator::apply(const Value& callee, const Expression& e, const Scope& scope) {
  const std::size_t given = e.children.size() - 1;
  const auto arguments = [&](std::size_t wanted) {
    if (given != wanted)
      fail(e, "expected " + std::to_string(wanted) +
                  (wanted == 1 ? " argument" : " arguments") + ", found " +
                  std::to_string(given));
    std::vector<Value> values;
    for (std::size_t i = 1; i <= given; ++i) values.push_back(evaluate(e.children[i], scope));
    return values;
  };
  const auto coordinates = [&](std::size_t wanted) {
    std::map<std::string, Scalar> map;
    const std::vector<Value> values = arguments(wanted);
    map.emplace(geometry::parameter_u, as_scalar(*this, values[0], e.children[1]));
    if (wanted == 2)
      map.emplace(geometry::parameter_v, as_scalar(*this, values[1], e.children[2]));
    return map;
  };
  const Formula u = Formula::symbol(geometry::parameter_u);
  const Formula v = Formula::symbol(geometry::parameter_v);

  if (const auto* patch = callee.as<geometry::Patch>())
    return vector_or_scalar(at_parameters(
        *this, scalars(geometry::evaluate(*patch, u, v), numbers), coordinates(2)));
  if (const auto* field = callee.as<Field>())
    return vector_or_scalar(at_parameters(*this, field->components, coordinates(2)));
  if (const auto* curve = callee.as<geometry::Curve>())
    return vector_or_scalar(
        at_parameters(*this, scalars(geometry::evaluate(*curve, u), numbers), coordinates(1)));
  if (const auto* field = callee.as<CurveField>())
    return vector_or_scalar(at_parameters(*this, field->components, coordinates(1)));
  if (const auto* function = callee.as<Function>()) {
    const Item& item = *function->item;
    if (item.kind == Item::Kind::sequence)
      return sequence_value(*this, item, as_scalar(*this, arguments(1)[0], e.children[1]), e);
    if (item.kind == Item::Kind::define)
      fail(e, "'" + item.name + "' is a statement, no value");
    const std::vector<Value> values = arguments(item.parameters.size());
    Scope inner;
    for (std::size_t i = 0; i < values.size(); ++i)
      inner.values[item.parameters[i]] = values[i];
    return evaluate(item.expressions[0], inner);
  }
  fail(e, description(callee) + " takes no arguments",
       callee.as<Scalar>() ? "a product is written with '*'" : "");
}

Value Evaluator::index(const Expression& e, const Scope& scope) {
  Value value = evaluate(e.children[0], scope);
  for (std::size_t i = 1; i < e.children.size(); ++i) {
    const std::vector<Value> items = as_items(*this, value, e.children[0]);
    const long k = integer(e.children[i], scope);
    if (k < 1 || k > std::ssize(items))
      fail(e.children[i],
           "index " + std::to_string(k) + " is outside 1.." + std::to_string(items.size()));
    value = items[k - 1];
  }
  return value;
}

Value Evaluator::list(const Expression& e, const Scope& scope) {
  if (auto items = finite_set(e, scope)) return {List{std::move(*items), false}};
  fail(e, "expected a list");
}

std::optional<std::vector<Value>> Evaluator::finite_set(const Expression& e,
                                                        const Scope& scope) {
  if (e.kind == Kind::range) {
    const long low = integer(e.children[0], scope), high = integer(e.children[1], scope);
    if (high - low > 1'000'000) fail(e, "a range of more than a million");
    std::vector<Value> items;
    for (long k = low; k <= high; ++k) items.push_back({Scalar(k)});
    return items;
  }
  if (e.kind == Kind::list) {
    std::vector<Value> items;
    for (const Expression& child : e.children) {
      if (child.kind == Kind::each) {
        for (Value& item : comprehension(*this, child, scope)) items.push_back(std::move(item));
      } else {
        items.push_back(evaluate(child, scope));
      }
    }
    return items;
  }
  if (e.kind == Kind::tuple || e.kind == Kind::half_open) return std::nullopt;
  const Value value = evaluate(e, scope);
  if (value.as<Region>()) return std::nullopt;
  return as_items(*this, value, e);
}

const Expression* set_of(const Expression& binding) {
  return binding.text == "all" || binding.children.size() < 2 ? nullptr : &binding.children[1];
}

const Expression* condition_of(const Expression& binding) {
  const std::size_t place = binding.text == "all" ? 1 : 2;
  return binding.children.size() > place ? &binding.children[place] : nullptr;
}

std::vector<Value> comprehension(Evaluator& evaluator, const Expression& each,
                                 const Scope& scope) {
  // One binding after the other; the last one runs fastest.
  std::vector<Value> values;
  const auto run = [&](auto&& self, std::size_t k, const Scope& around) -> void {
    if (k == each.children.size()) {
      values.push_back(evaluator.evaluate(each.children[0], around));
      return;
    }
    const Expression& binding = each.children[k];
    if (condition_of(binding)) throw Unsupported("a 'where' in a list, a sum or a count");
    const auto set =
        set_of(binding) ? evaluator.finite_set(*set_of(binding), around) : std::nullopt;
    if (!set) fail(binding, "expected a finite set here: a list or a range");
    const auto& names = binding.children[0].children;
    for (const Value& item : *set) {
      Scope inner{&around, {}};
      if (names.size() == 1) {
        inner.values[names[0].text] = item;
      } else {
        const auto parts = as_items(evaluator, item, binding);
        if (parts.size() != names.size())
          fail(binding, "these items do not split into that many names");
        for (std::size_t i = 0; i < names.size(); ++i) inner.values[names[i].text] = parts[i];
      }
      self(self, k + 1, inner);
    }
  };
  run(run, 1, scope);
  return values;
}

}  // namespace seam::claims
