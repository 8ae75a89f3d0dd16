// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/solving.h"

// "solve x: S gives s1, s2": S is a conjunction of equations, perhaps for all values of further
// variables; it becomes the system of their differences.

namespace seam::claims {
namespace {

using Kind = Expression::Kind;

class Collector {
 public:
  explicit Collector(Solving& solving) : solving_(solving) {}

  void collect(const Expression& e, const Scope& scope);

 private:
  void equate(const Expression& at, const Value& a, const Value& b);
  void define(const Expression& e, const Scope& scope);
  void quantify(const Expression& e, const Scope& scope);

  Evaluator& evaluator() { return solving_.evaluator(); }
  Solving& solving_;
};

void Collector::equate(const Expression& at, const Value& a, const Value& b) {
  if (a.as<Scalar>() && b.as<Scalar>()) {
    for (const Scalar* side : {a.as<Scalar>(), b.as<Scalar>()})
      for (const Formula& f : side->radicands)
        for (const std::string& unknown : solving_.unknowns)
          if (symbolic::variables(f).contains(unknown))
            throw Unsupported("an equation with the unknown under a root");
    // What the equation divides by is stated not to be 0 wherever the unknowns may lie.
    Context context = solving_.around;
    for (std::size_t j = 0; j < solving_.unknowns.size(); ++j) {
      if (solving_.sets[j])
        context.factors.push_back(evaluator().continuous_set(
            *solving_.sets[j], {solving_.unknowns[j]}, solving_.scope));
      else
        context.lines.push_back(solving_.unknowns[j]);
    }
    context.lines.insert(context.lines.end(), solving_.for_all.begin(), solving_.for_all.end());
    solving_.equations.push_back(
        solving_.stating.compared(*a.as<Scalar>(), "=", *b.as<Scalar>(), context, at).formula);
    return;
  }
  const auto left = as_items(evaluator(), a, at), right = as_items(evaluator(), b, at);
  if (left.size() != right.size()) fail(at, "these sides differ in size");
  for (std::size_t i = 0; i < left.size(); ++i) equate(at, left[i], right[i]);
}

void Collector::quantify(const Expression& e, const Scope& scope) {
  Scope inner{&scope, {}};
  for (std::size_t i = 0; i + 1 < e.children.size(); ++i) {
    if (e.children[i].text != "all" || condition_of(e.children[i]))
      throw Unsupported("'solve' with a bounded 'for' inside");
    for (const Expression& name : e.children[i].children[0].children) {
      solving_.for_all.push_back(evaluator().bind(name.text));
      inner.values[name.text] = {Scalar(Formula::symbol(solving_.for_all.back()))};
    }
  }
  collect(e.children.back(), inner);
}

void Collector::define(const Expression& e, const Scope& scope) {
  const auto found = evaluator().globals.find(e.children[0].text);
  if (found == evaluator().globals.end() || !found->second.item ||
      found->second.item->kind != Item::Kind::define)
    throw Unsupported("'solve' is covered for equations, 'and', and 'for all' only");
  const Item& item = *found->second.item;
  if (item.parameters.size() + 1 != e.children.size()) fail(e, "wrong number of arguments");
  Scope inner;
  for (std::size_t i = 0; i < item.parameters.size(); ++i)
    inner.values[item.parameters[i]] = evaluator().evaluate(e.children[i + 1], scope);
  collect(item.expressions[0], inner);
}

void Collector::collect(const Expression& e, const Scope& scope) {
  if (e.kind == Kind::conjunction) {
    collect(e.children[0], scope);
    collect(e.children[1], scope);
  } else if (e.kind == Kind::relation && e.text == "=") {
    equate(e, evaluator().evaluate(e.children[0], scope),
           evaluator().evaluate(e.children[1], scope));
  } else if (e.kind == Kind::relation && &scope == &solving_.scope) {
    solving_.conditions.push_back(&e);
  } else if (e.kind == Kind::for_all) {
    quantify(e, scope);
  } else if (e.kind == Kind::call) {
    define(e, scope);
  } else {
    throw Unsupported("'solve' is covered for equations, 'and', and 'for all' only");
  }
}

void bind(Solving& solving, const Expression& name, const Expression* set) {
  solving.unknowns.push_back(solving.evaluator().bind(name.text));
  solving.sets.push_back(set);
  solving.scope.values[name.text] = {Scalar(Formula::symbol(solving.unknowns.back()))};
}

}  // namespace

Proposition Stating::solved(const Expression& e, const Scope& scope, const Context& context) {
  Solving solving{*this, e, context, {&scope, {}}, {}, {}, {}, {}, {}};
  for (const Expression& unknown : e.children[0].children) {
    if (unknown.kind != Kind::binding) {
      bind(solving, unknown, nullptr);
      continue;
    }
    const auto& names = unknown.children[0].children;
    if (names.size() != 1) throw Unsupported("'solve' for a tuple of unknowns from one set");
    bind(solving, names[0], set_of(unknown));
    if (const Expression* condition = condition_of(unknown))
      solving.conditions.push_back(condition);
  }
  for (const Expression& condition : e.children[2].children)
    solving.conditions.push_back(&condition);
  Collector(solving).collect(e.children[1], solving.scope);

  auto alone = solved_alone(solving);
  Proposition result = alone ? std::move(*alone) : solved_together(solving);
  for (const std::string& symbol : solving.unknowns) evaluator.release(symbol);
  for (const std::string& symbol : solving.for_all) evaluator.release(symbol);
  return result;
}

}  // namespace seam::claims
