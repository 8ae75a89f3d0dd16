// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "claims/order.h"
#include "claims/stating.h"

// "for some x: S" is "not for all x: not S". Finite sets are written out. Symbols of
// quantifiers that are open at the same time are different, whatever their names.

namespace seam::claims {
namespace {

using Kind = Expression::Kind;

bool is_infinite(const Expression& e) {
  return e.kind == Kind::infinity ||
         (e.kind == Kind::negate && e.children[0].kind == Kind::infinity);
}

}  // namespace

bool Evaluator::is_interval(const Expression& set, const Scope& scope) {
  if (set.kind == Kind::tuple || set.kind == Kind::half_open) return set.children.size() == 2;
  if (set.kind != Kind::list || set.children.size() != 2) return false;
  return std::ranges::all_of(set.children, [&](const Expression& end) {
    if (is_infinite(end)) return true;
    return end.kind != Kind::each && evaluate(end, scope).as<Scalar>() != nullptr;
  });
}

symbolic::Simplex Evaluator::continuous_set(const Expression& set,
                                            const std::vector<std::string>& symbols,
                                            const Scope& scope) {
  if (is_interval(set, scope)) {
    if (symbols.size() != 1) fail(set, "an interval is a set for one variable");
    const bool open_low = set.kind == Kind::tuple || set.text == "(]";
    const bool open_high = set.kind == Kind::tuple || set.text == "[)";
    const Expression &low = set.children[0], &high = set.children[1];
    if (is_infinite(low) && is_infinite(high)) fail(set, "say 'for all' for every real number");
    if (is_infinite(low))
      return symbolic::whole_line_left(symbols[0], number(high, scope), open_high);
    if (is_infinite(high))
      return symbolic::whole_line_right(symbols[0], number(low, scope), open_low);
    const Formula a = number(low, scope), b = number(high, scope);
    if (numbers.sign(b - a) != exact::Sign::positive)
      fail(set, "this interval is empty or a single point",
           "its first end must be less than its second");
    return symbolic::interval(symbols[0], a, b, open_low, open_high);
  }
  const Value value = evaluate(set, scope);
  const auto* region = value.as<Region>();
  if (!region)
    fail(set, "expected a set: an interval, 'triangle', a list; found " + description(value));
  if (region->dimension != static_cast<int>(symbols.size()))
    fail(set, "this set has dimension " + std::to_string(region->dimension) + ", not " +
                  std::to_string(symbols.size()));
  if (region->square) fail(set, "write a square as 'u in [0, 1], v in [0, 1]'");
  return symbolic::standard_simplex(symbols, region->interior);
}

Proposition Stating::quantified(const Expression& e, const Scope& scope, const Context& context,
                                bool positive) {
  const bool existential = (e.kind == Kind::for_some) == positive;
  const Expression& body = e.children.back();
  std::vector<std::string> symbols;

  // `sign`: what becomes of the body; under an existential everything is stated for all, and
  // negated outside.
  const auto run = [&](auto&& self, std::size_t k, const Scope& around, const Context& inner,
                       bool universal) -> Proposition {
    if (k + 1 == e.children.size())
      return state(body, around, inner, universal ? positive : !positive);
    const Expression& binding = e.children[k];
    const auto& names = binding.children[0].children;
    Scope scope_here{&around, {}};
    Context context_here = inner;
    const bool has_set = binding.text != "all";

    if (has_set && !evaluator.is_interval(binding.children[1], around)) {
      if (auto items = evaluator.finite_set(binding.children[1], around)) {
        if (items->empty()) fail(binding, "there is nothing to range over", "the set is empty");
        std::vector<Proposition> parts;
        for (const Value& item : *items) {
          scope_here.values.clear();
          if (names.size() == 1) {
            scope_here.values[names[0].text] = item;
          } else {
            const auto entries = as_items(evaluator, item, binding);
            if (entries.size() != names.size())
              fail(binding, "these items do not split into that many names");
            for (std::size_t i = 0; i < names.size(); ++i)
              scope_here.values[names[i].text] = entries[i];
          }
          const Expression* condition = condition_of(binding);
          if (condition && !inner.empty()) {
            auto where = constraints(*condition, scope_here, inner, true);
            if (!where) throw Unsupported("this condition on a finite set under 'for all'");
            Context narrowed = inner;
            narrowed.where.insert(narrowed.where.end(), where->begin(), where->end());
            parts.push_back(self(self, k + 1, scope_here, narrowed, universal));
            continue;
          }
          Proposition part = self(self, k + 1, scope_here, inner, universal);
          if (condition)
            part = symbolic::any(
                {symbolic::negation(state(*condition, scope_here, inner)), std::move(part)});
          parts.push_back(std::move(part));
        }
        return symbolic::all(std::move(parts));
      }
    }
    std::vector<std::string> here;
    for (const Expression& name : names) {
      here.push_back(evaluator.bind(name.text));
      symbols.push_back(here.back());
      scope_here.values[name.text] = {Scalar(Formula::symbol(here.back()))};
    }
    if (has_set)
      context_here.factors.push_back(
          evaluator.continuous_set(binding.children[1], here, around));
    else
      context_here.lines.insert(context_here.lines.end(), here.begin(), here.end());
    if (const Expression* condition = condition_of(binding)) {
      auto where = constraints(*condition, scope_here, context_here, true);
      if (!where) fail(*condition, "a condition after 'where' compares polynomials");
      context_here.where.insert(context_here.where.end(), where->begin(), where->end());
      order_to_triangle(context_here, evaluator.numbers);
    }
    return self(self, k + 1, scope_here, context_here, universal);
  };

  if (existential && !context.empty())
    throw Unsupported("'for some' inside 'for all' over an infinite set is not covered");
  // The innermost statement under an existential is negated; `state` gets the sign, `negation`
  // undoes it.
  Proposition result = run(run, 0, scope, context, !existential);
  for (const std::string& symbol : symbols) evaluator.release(symbol);
  return existential ? symbolic::negation(std::move(result)) : result;
}

}  // namespace seam::claims
