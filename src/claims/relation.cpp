// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "claims/stating.h"

// Comparisons of values of all kinds: entry by entry, point by point, for all points of a
// patch; with an extremum, at all or at some points of its domain.

namespace seam::claims {
namespace {

using exact::Rational;
using symbolic::Constraint;
using Kind = Expression::Kind;

std::vector<std::string> operations(const Expression& e) {
  std::vector<std::string> result;
  std::size_t begin = 0;
  while (begin < e.text.size()) {
    const std::size_t end = std::min(e.text.find(' ', begin), e.text.size());
    if (end > begin) result.push_back(e.text.substr(begin, end - begin));
    begin = end + 1;
  }
  return result;
}

}  // namespace

std::string negated_operation(const std::string& operation) {
  if (operation == "=") return "!=";
  if (operation == "!=") return "=";
  if (operation == "<") return ">=";
  if (operation == "<=") return ">";
  if (operation == ">") return "<=";
  return "<";
}

namespace {

// Of two tuples of numbers: 0 where they are equal.
std::optional<Scalar> squared_distance(const std::vector<Value>& a,
                                       const std::vector<Value>& b) {
  Scalar sum(0);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const auto *x = a[i].as<Scalar>(), *y = b[i].as<Scalar>();
    if (!x || !y) return std::nullopt;
    const Scalar difference = *x - *y;
    sum = sum + difference * difference;
  }
  return sum;
}

// 0 beside a vector is the vector 0.
Value beside(const Value& value, const Value& other) {
  const auto* scalar = value.as<Scalar>();
  const auto* vector = other.as<Vector>();
  if (!scalar || !vector || !is_number(*scalar) || !scalar->numerator.is(0)) return value;
  return {Vector(vector->size())};
}

}  // namespace

Proposition Stating::entries(const Expression& at, const std::vector<Value>& a,
                             const std::vector<Value>& b, const std::string& operation,
                             const Context& context, bool positive) {
  if (operation != "=" && operation != "!=")
    fail(at, "'" + operation + "' compares numbers only");
  const bool equal = (operation == "=") == positive;
  std::vector<Proposition> parts;
  for (std::size_t i = 0; i < a.size(); ++i)
    parts.push_back(compare(at, a[i], "=", b[i], context, true));
  Proposition all = symbolic::all(std::move(parts));
  if (equal) return all;
  if (context.empty()) return symbolic::negation(std::move(all));
  const auto distance = squared_distance(a, b);
  if (!distance) throw Unsupported("'!=' of lists under 'for all' is not covered");
  return compare(at, {*distance}, "!=", {Scalar(0)}, context, true);
}

namespace {

std::vector<Value> points_of(const geometry::Patch& patch, Numbers& numbers) {
  std::vector<Value> points;
  for (const auto& row : patch.rows())
    for (const auto& point : row) points.push_back(vector_value(point, numbers));
  return points;
}

bool same_shape(const geometry::Patch& p, const geometry::Patch& q) {
  return p.shape() == q.shape() && p.degree_u() == q.degree_u() && p.degree_v() == q.degree_v();
}

}  // namespace

Proposition Stating::compare(const Expression& at, const Value& left,
                             const std::string& operation, const Value& right,
                             const Context& context, bool positive) {
  const Value a = beside(left, right), b = beside(right, left);
  if (const auto* question = a.as<Minimax>())
    return compare_minimax(at, *question, positive ? operation : negated_operation(operation),
                           as_scalar(evaluator, b, at), context);
  if (const auto* extremum = a.as<Extremum>()) {
    const Value bound = b.as<Extremum>() ? evaluator.resolved(b, at) : b;
    const std::string op = positive ? operation : negated_operation(operation);
    return compare_extremum(at, *extremum, op, as_scalar(evaluator, bound, at), context);
  }
  if (b.as<Extremum>() || b.as<Minimax>()) {
    static const std::map<std::string, std::string> mirrored = {
        {"<", ">"}, {"<=", ">="}, {">", "<"}, {">=", "<="}};
    const auto found = mirrored.find(operation);
    return compare(at, b, found == mirrored.end() ? operation : found->second, a, context,
                   positive);
  }
  if (const auto* f = a.as<Field>(), *g = b.as<Field>(); f || g) {
    const geometry::Patch::Shape shape = f ? f->shape : g->shape;
    if (f && g && f->shape != g->shape) fail(at, "these functions live on different domains");
    Context inner = context;
    const std::vector<std::string> names = {geometry::parameter_u, geometry::parameter_v};
    if (shape == geometry::Patch::Shape::triangle) {
      inner.factors.push_back(symbolic::standard_simplex(names));
    } else {
      for (const std::string& name : names)
        inner.factors.push_back(symbolic::interval(name, 0, 1));
    }
    const auto plain = [](const Value& v) {
      const auto* field = v.as<Field>();
      if (!field) return v;
      return field->components.size() == 1 ? Value{field->components[0]}
                                           : Value{Vector(field->components)};
    };
    if (!positive && !context.empty())
      throw Unsupported("a negated statement about a whole patch under 'for all'");
    Proposition p = compare(at, plain(a), operation, plain(b), inner, true);
    return positive ? p : symbolic::negation(std::move(p));
  }
  if (a.as<Scalar>() && b.as<Scalar>()) {
    const std::string op = positive ? operation : negated_operation(operation);
    // |E| <= b says that E <= b and -E <= b.
    const auto inside = inside_absolute(*a.as<Scalar>());
    if (inside && (op == "<" || op == "<="))
      return symbolic::all({compare(at, {*inside}, op, b, context, true),
                            compare(at, {-*inside}, op, b, context, true)});
    if (inside_absolute(*b.as<Scalar>()) && (op == ">" || op == ">="))
      return compare(at, b, op == ">" ? "<" : "<=", a, context, true);
    const Constraint c = compared(*a.as<Scalar>(), op, *b.as<Scalar>(), context, at);
    return measured(holds(c.formula, c.relation, context, at), c,
                    "the difference of the sides");
  }
  const auto *p = a.as<geometry::Patch>(), *q = b.as<geometry::Patch>();
  if (p && q) {
    const auto points = points_of(*p, evaluator.numbers),
               others = points_of(*q, evaluator.numbers);
    if (!same_shape(*p, *q)) {
      if (operation != "=" && operation != "!=")
        fail(at, "'" + operation + "' compares numbers only");
      return (operation == "=") == positive ? symbolic::falsehood() : symbolic::truth();
    }
    return entries(at, points, others, operation, context, positive);
  }
  const auto *c = a.as<geometry::Curve>(), *d = b.as<geometry::Curve>();
  if (c && d) {
    const Formula u = Formula::symbol(geometry::parameter_u);
    Context everywhere = context;
    everywhere.lines.push_back(geometry::parameter_u);
    return compare(at, vector_value(geometry::evaluate(*c, u), evaluator.numbers), operation,
                   vector_value(geometry::evaluate(*d, u), evaluator.numbers), everywhere,
                   positive);
  }
  const bool lists = (a.as<List>() || a.as<Vector>() || a.as<MatrixValue>()) &&
                     (b.as<List>() || b.as<Vector>() || b.as<MatrixValue>());
  if (!lists)
    fail(at,
         "'" + operation + "' does not compare " + description(a) + " with " + description(b));
  const auto entries_a = as_items(evaluator, a, at), entries_b = as_items(evaluator, b, at);
  if (entries_a.size() != entries_b.size()) {
    if (a.as<Vector>() || b.as<Vector>() || (operation != "=" && operation != "!="))
      fail(at, "these have " + std::to_string(entries_a.size()) + " and " +
                   std::to_string(entries_b.size()) + " entries");
    return (operation == "=") == positive ? symbolic::falsehood() : symbolic::truth();
  }
  return entries(at, entries_a, entries_b, operation, context, positive);
}

Proposition Stating::relation(const Expression& e, const Scope& scope, const Context& context,
                              bool positive) {
  const bool truncated = e.kind == Kind::truncated;
  const Expression& chain = truncated ? e.children[0] : e;
  const std::vector<std::string> ops = operations(chain);
  std::vector<Value> values;
  for (const Expression& child : chain.children)
    values.push_back(evaluator.evaluate(child, scope));
  std::vector<Proposition> parts;
  for (std::size_t i = 0; i < ops.size(); ++i) {
    if (ops[i] == "~")
      parts.push_back(
          approximation(chain, values[i], chain.children[i + 1], truncated, context, positive));
    else
      parts.push_back(compare(chain, values[i], ops[i], values[i + 1], context, positive));
  }
  if (parts.size() == 1) return parts.front();
  if (positive) return symbolic::all(std::move(parts));
  if (!context.empty())
    throw Unsupported("the negation of a chain of comparisons under 'for all'");
  return symbolic::any(std::move(parts));
}

std::optional<std::vector<Constraint>> Stating::constraints(const Expression& e,
                                                            const Scope& scope,
                                                            const Context& context,
                                                            bool positive) {
  const auto both = [&](bool left, bool right) -> std::optional<std::vector<Constraint>> {
    auto a = constraints(e.children[0], scope, context, left);
    auto b = constraints(e.children[1], scope, context, right);
    if (!a || !b) return std::nullopt;
    a->insert(a->end(), b->begin(), b->end());
    return a;
  };
  if (e.kind == Kind::negation) return constraints(e.children[0], scope, context, !positive);
  if (e.kind == Kind::conjunction && positive) return both(true, true);
  if (e.kind == Kind::disjunction && !positive) return both(false, false);
  if (e.kind == Kind::implication && !positive) return both(true, false);
  if (e.kind != Kind::relation) return std::nullopt;
  const auto ops = operations(e);
  if (!positive && ops.size() > 1) return std::nullopt;
  std::vector<Constraint> result;
  for (std::size_t i = 0; i < ops.size(); ++i) {
    if (ops[i] == "~") return std::nullopt;
    const Value first = evaluator.evaluate(e.children[i], scope),
                second = evaluator.evaluate(e.children[i + 1], scope);
    const Value a = beside(first, second), b = beside(second, first);
    const std::string op = positive ? ops[i] : negated_operation(ops[i]);
    if (a.as<Vector>() && b.as<Vector>() && (op == "=" || op == "!=")) {
      const auto left = as_items(evaluator, a, e), right = as_items(evaluator, b, e);
      if (left.size() != right.size()) return std::nullopt;
      if (op == "!=")
        result.push_back(compared(*squared_distance(left, right), ">", Scalar(0), context, e));
      else
        for (std::size_t k = 0; k < left.size(); ++k)
          result.push_back(
              compared(*left[k].as<Scalar>(), op, *right[k].as<Scalar>(), context, e));
      continue;
    }
    const auto *x = a.as<Scalar>(), *y = b.as<Scalar>();
    if (!x || !y) return std::nullopt;
    result.push_back(compared(*x, op, *y, context, e));
  }
  return result;
}

bool Stating::assume(const Expression& e, const Scope& scope, Context& context, bool positive) {
  const bool is_both =
      (e.kind == Kind::conjunction && positive) || (e.kind == Kind::disjunction && !positive);
  if (is_both) {
    // What the second rests on it does so without the first.
    const Context around = context;
    Context second = around;
    if (!assume(e.children[0], scope, context, positive) ||
        !assume(e.children[1], scope, second, positive))
      return false;
    const auto join = [](auto& to, const auto& from, std::size_t known) {
      to.insert(to.end(), from.begin() + static_cast<long>(known), from.end());
    };
    join(context.where, second.where, around.where.size());
    join(context.given, second.given, around.given.size());
    return true;
  }
  if (e.kind == Kind::negation) return assume(e.children[0], scope, context, !positive);
  if (e.kind == Kind::for_all && positive && e.children.size() == 2 &&
      e.children[0].text == "all" && condition_of(e.children[0]) == nullptr) {
    Assumption assumption;
    Scope inner{&scope, {}};
    Context around = context;
    for (const Expression& name : e.children[0].children[0].children) {
      assumption.variables.push_back(evaluator.bind(name.text));
      around.lines.push_back(assumption.variables.back());
      inner.values[name.text] = {Scalar(Formula::symbol(assumption.variables.back()))};
    }
    const auto found = constraints(e.children[1], inner, around, true);
    for (const std::string& symbol : assumption.variables) evaluator.release(symbol);
    if (!found) return false;
    assumption.constraints = *found;
    context.given.push_back(std::move(assumption));
    return true;
  }
  const auto found = constraints(e, scope, context, positive);
  if (!found) return false;
  context.where.insert(context.where.end(), found->begin(), found->end());
  return true;
}

}  // namespace seam::claims
