// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "claims/stating.h"

// A comparison of quotients a/b and c/d becomes one of polynomials: (a d - c b) * sign(b d)
// with 0. The sign of a divisor is read off at one point of the context and stated as a guard
// for all of it, so that nothing rests on the reading. Under constraints the context may fall
// apart into pieces with different signs; there no sign is assumed, and b d is
// multiplied in.

namespace seam::claims {
namespace {

using exact::Rational;
using symbolic::Constraint;
using symbolic::Simplex;
using Kind = Expression::Kind;

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

bool touches(const Simplex& factor, const std::set<std::string>& variables) {
  return std::ranges::any_of(factor.variables,
                             [&](const auto& v) { return variables.contains(v); });
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

Proposition Stating::holds(const Formula& f, Relation relation, const Context& context,
                           const Expression& at, const std::string& about) {
  for (const Constraint& constraint : context.where)
    if (symbolic::variables(constraint.formula).empty())
      throw Unsupported("a condition without variables");
  std::set<std::string> open = symbolic::variables(f);
  for (const Constraint& constraint : context.where)
    open.merge(symbolic::variables(constraint.formula));
  if (open.empty() && context.where.empty()) {
    if (relation == Relation::zero) return symbolic::atom(symbolic::Zero{f}, about);
    return symbolic::atom(symbolic::Sign{f, relation, {}}, about);
  }

  symbolic::Domain domain;
  domain.where = context.where;
  std::vector<std::string> lines;
  std::set<std::string> bound;
  const auto use_factor = [&](const Simplex& factor) {
    for (const std::string& v : factor.variables)
      if (bound.contains(v) && symbolic::variables(f).contains(v))
        throw Unsupported("a variable that is bound twice");
    if (!touches(factor, open)) return;
    bound.insert(factor.variables.begin(), factor.variables.end());
    domain.factors.push_back(factor);
    for (const std::string& v : factor.variables) open.erase(v);
  };
  for (const Simplex& factor : context.factors) use_factor(factor);
  for (const std::string& line : context.lines)
    if (open.erase(line)) lines.push_back(line);
  for (const Parameter& parameter : evaluator.parameters) {
    if (bound.contains(parameter.name)) continue;  // the context has it
    if (parameter.set)
      use_factor(*parameter.set);
    else if (open.erase(parameter.name))
      lines.push_back(parameter.name);
  }
  if (!open.empty())
    fail(at, "the variable '" + *open.begin() + "' is not bound here",
         "say 'for all " + *open.begin() + ":' or where it ranges");

  if (relation == Relation::zero && domain.where.empty())
    return symbolic::atom(symbolic::Zero{f}, about);
  if (lines.size() > 4)
    throw Unsupported("an inequality for all values of more than four reals");
  std::vector<symbolic::Domain> domains = {domain};
  for (const std::string& line : lines) {
    std::vector<symbolic::Domain> halves;
    for (const symbolic::Domain& d : domains) {
      halves.push_back(d);
      halves.back().factors.push_back(symbolic::whole_line_left(line, 0, false));
      halves.push_back(d);
      halves.back().factors.push_back(symbolic::whole_line_right(line, 0, false));
    }
    domains = std::move(halves);
  }
  std::vector<Proposition> parts;
  for (symbolic::Domain& d : domains)
    parts.push_back(symbolic::atom(symbolic::Sign{f, relation, std::move(d)}, about));
  return parts.size() == 1 ? parts.front() : symbolic::all(std::move(parts), about);
}

// The sign at some point inside the context; nothing where it is 0 at all points tried.
std::optional<exact::Sign> Stating::sample_sign(const Formula& f, const Context& context) {
  for (const long weight : {1, 2, 3, 5, 8}) {
    std::map<std::string, Formula> point;
    const auto place = [&](const Simplex& factor) {
      Formula total = 0;
      symbolic::Point sum(factor.variables.size(), Formula(0));
      for (std::size_t c = 0; c < factor.corners.size(); ++c) {
        const Formula share(c == 0 ? weight : 1);
        total += share * factor.corners[c][0];
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += share * factor.corners[c][i + 1];
      }
      const Formula inverse = evaluator.numbers.inverse(total);
      for (std::size_t i = 0; i < sum.size(); ++i)
        point[factor.variables[i]] = evaluator.numbers.normal_form(sum[i] * inverse);
    };
    for (const Parameter& parameter : evaluator.parameters) {
      if (parameter.set)
        place(*parameter.set);
      else
        point[parameter.name] = Formula(weight);
    }
    for (const Simplex& factor : context.factors) place(factor);
    for (const std::string& line : context.lines) point[line] = Formula(weight);
    const Formula value = symbolic::subst(f, point);
    if (!symbolic::is_number(value)) return std::nullopt;
    const exact::Sign sign = evaluator.numbers.sign(value);
    if (sign != exact::Sign::zero) return sign;
  }
  return std::nullopt;
}

void Stating::guard_divisors(const Scalar& value, const Context& context,
                             const Expression& at) {
  for (const Formula& divisor : value.divisors) {
    const auto sign = context.where.empty() ? sample_sign(divisor, context) : std::nullopt;
    const Relation relation = !sign                            ? Relation::nonzero
                              : *sign == exact::Sign::positive ? Relation::positive
                                                               : Relation::negative;
    guards.push_back(holds(divisor, relation, context, at, "the divisor is not 0"));
  }
}

Constraint Stating::compared(const Scalar& a, const std::string& operation, const Scalar& b,
                             const Context& context, const Expression& at) {
  guard_divisors(a, context, at);
  guard_divisors(b, context, at);
  const Scalar difference = a - b;
  const Relation relation = relation_of(operation);
  if (difference.denominator.is(1) || relation == Relation::zero ||
      relation == Relation::nonzero)
    return {difference.numerator, relation};
  const auto sign =
      context.where.empty() ? sample_sign(difference.denominator, context) : std::nullopt;
  if (!sign) return {difference.numerator * difference.denominator, relation};
  return {difference.numerator, *sign == exact::Sign::positive ? relation : flipped(relation)};
}

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
  if (!context.empty()) throw Unsupported("'!=' of vectors under 'for all' is not covered");
  return symbolic::negation(std::move(all));
}

namespace {

std::vector<Value> points_of(const geometry::Patch& patch) {
  std::vector<Value> points;
  for (const auto& row : patch.rows())
    for (const auto& point : row) points.push_back(vector_value(point));
  return points;
}

bool same_shape(const geometry::Patch& p, const geometry::Patch& q) {
  return p.shape() == q.shape() && p.degree_u() == q.degree_u() && p.degree_v() == q.degree_v();
}

}  // namespace

Proposition Stating::compare(const Expression& at, const Value& a, const std::string& operation,
                             const Value& b, const Context& context, bool positive) {
  if (const auto* question = a.as<Minimax>())
    return compare_minimax(at, *question, positive ? operation : negated_operation(operation),
                           as_scalar(evaluator, b, at), context);
  if (const auto* extremum = a.as<Extremum>()) {
    const Value right = b.as<Extremum>() ? evaluator.resolved(b, at) : b;
    const std::string op = positive ? operation : negated_operation(operation);
    return compare_extremum(at, *extremum, op, as_scalar(evaluator, right, at), context);
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
    const Constraint c = compared(*a.as<Scalar>(), op, *b.as<Scalar>(), context, at);
    return holds(c.formula, c.relation, context, at);
  }
  const auto *p = a.as<geometry::Patch>(), *q = b.as<geometry::Patch>();
  if (p && q) {
    const auto points = points_of(*p), others = points_of(*q);
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
    return compare(at, vector_value(geometry::evaluate(*c, u)), operation,
                   vector_value(geometry::evaluate(*d, u)),
                   Context{context.factors,
                           [&] {
                             auto l = context.lines;
                             l.push_back(geometry::parameter_u);
                             return l;
                           }(),
                           context.where},
                   positive);
  }
  const bool lists = (a.as<List>() || a.as<Vector>() || a.as<MatrixValue>()) &&
                     (b.as<List>() || b.as<Vector>() || b.as<MatrixValue>());
  if (!lists)
    fail(at,
         "'" + operation + "' does not compare " + description(a) + " with " + description(b));
  const auto left = as_items(evaluator, a, at), right = as_items(evaluator, b, at);
  if (left.size() != right.size()) {
    if (a.as<Vector>() || b.as<Vector>() || (operation != "=" && operation != "!="))
      fail(at, "these have " + std::to_string(left.size()) + " and " +
                   std::to_string(right.size()) + " entries");
    return (operation == "=") == positive ? symbolic::falsehood() : symbolic::truth();
  }
  return entries(at, left, right, operation, context, positive);
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
    const Value a = evaluator.evaluate(e.children[i], scope),
                b = evaluator.evaluate(e.children[i + 1], scope);
    const auto *x = a.as<Scalar>(), *y = b.as<Scalar>();
    if (!x || !y) return std::nullopt;
    result.push_back(
        compared(*x, positive ? ops[i] : negated_operation(ops[i]), *y, context, e));
  }
  return result;
}

}  // namespace seam::claims
