// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "claims/evaluate.h"
#include "symbolic/coefficients.h"

// Patches and curves from their control points, as printed in rows or labelled by
// index, and from polynomial formulas.

namespace seam::claims {
namespace {

using geometry::Curve;
using geometry::Patch;
using symbolic::Point;

using Kind = Expression::Kind;

using Rows = std::vector<std::vector<Point>>;

void require_one_dimension(const Rows& rows, const Expression& at) {
  for (const auto& row : rows)
    for (const Point& point : row)
      if (point.size() != rows[0][0].size())
        fail(at, "these control points are not all of one dimension");
}

Value patch_of_rows(Rows rows, bool triangle, const Expression& at) {
  require_one_dimension(rows, at);
  for (std::size_t j = 0; j < rows.size(); ++j) {
    const std::size_t expected = triangle ? rows.size() - j : rows[0].size();
    if (rows[j].size() != expected)
      fail(at.children.size() == rows.size() ? at.children[j] : at,
           "row " + std::to_string(j + 1) + " has " + std::to_string(rows[j].size()) +
               " control points, expected " + std::to_string(expected));
  }
  if (rows.size() < 2 && triangle) fail(at, "a patch of degree 0 is a point");
  if (!triangle && (rows.size() < 2 || rows[0].size() < 2))
    fail(at, "a quad patch has at least two rows of two control points");
  return {triangle ? Patch::triangle(std::move(rows)) : Patch::square(std::move(rows))};
}

Point control_point(Evaluator& evaluator, const Expression& e, const Scope& scope) {
  const Value value = evaluator.evaluate(e, scope);
  if (!value.as<Vector>()) fail(e, "expected a control point, found " + description(value));
  return as_point(evaluator, value, e);
}

Value printed(Evaluator& evaluator, const Expression& e, const Scope& scope) {
  Rows rows;
  for (const Expression& row : e.children) {
    rows.emplace_back();
    for (const Expression& entry : row.children) {
      if (entry.kind == Kind::each) {
        for (const Value& value : comprehension(evaluator, entry, scope))
          rows.back().push_back(as_point(evaluator, value, entry));
      } else {
        rows.back().push_back(control_point(evaluator, entry, scope));
      }
    }
    if (rows.back().empty()) fail(row, "a row without control points");
  }
  if (rows.empty()) fail(e, "no control points");
  if (e.text == "curve") {
    if (rows.size() != 1) fail(e, "a curve has one row of control points");
    require_one_dimension(rows, e);
    if (rows[0].size() < 2) fail(e, "a curve has at least two control points");
    return {Curve{rows[0]}};
  }
  return patch_of_rows(std::move(rows), e.text == "triangle_patch", e);
}

// b_ijk belongs to u^i v^j w^k; row j, entry i.
Value labelled(Evaluator& evaluator, const Expression& e, const Scope& scope) {
  if (e.text != "triangle_patch")
    throw Unsupported("index labels are covered for triangle patches only");
  const long degree = evaluator.integer(e.children[0], scope);
  if (degree < 1 || degree > 9) fail(e.children[0], "a degree from 1 to 9 is expected here");
  Rows rows(degree + 1);
  for (long j = 0; j <= degree; ++j) rows[j].resize(degree + 1 - j);
  for (std::size_t c = 1; c < e.children.size(); ++c) {
    const Expression& control = e.children[c];
    const std::string& label = control.text;
    const bool digits =
        label.size() == 3 && label.find_first_not_of("0123456789") == std::string::npos;
    const int i = digits ? label[0] - '0' : 0, j = digits ? label[1] - '0' : 0;
    if (!digits || i + j + (label[2] - '0') != degree)
      fail(control, "expected three digits that add up to " + std::to_string(degree));
    if (!rows[j][i].empty()) fail(control, "control point " + label + " is given twice");
    rows[j][i] = control_point(evaluator, control.children[0], scope);
  }
  for (long j = 0; j <= degree; ++j)
    for (long i = 0; i + j <= degree; ++i)
      if (rows[j][i].empty())
        fail(e, "control point " + std::to_string(i) + std::to_string(j) +
                    std::to_string(degree - i - j) + " is missing");
  return patch_of_rows(std::move(rows), true, e);
}

exact::Rational binomial(int n, int k) {
  exact::Integer value;
  mpz_bin_uiui(value.get_mpz_t(), n, k);
  return value;
}

bool is_bound(const Scope& scope, const std::string& name) {
  for (const Scope* s = &scope; s; s = s->outer)
    if (s->values.contains(name)) return true;
  return false;
}

// Neither a quotient nor a root nor a function holds these symbols.
bool is_polynomial_in(const Formula& f, const std::set<std::string>& symbols) {
  if (f.is_polynomial()) return true;
  const bool is_function = f.kind() == Formula::Kind::inverse ||
                           f.kind() == Formula::Kind::root ||
                           f.kind() == Formula::Kind::applied;
  if (is_function) {
    const auto held = symbolic::symbols(f);
    return std::ranges::none_of(symbols, [&](const auto& s) { return held.contains(s); });
  }
  return std::ranges::all_of(f.operands(),
                             [&](const Formula& g) { return is_polynomial_in(g, symbols); });
}

// A point that is no polynomial, as a function on the domain of the patch.
Value formula_field(Evaluator& evaluator, const Expression& e, const Point& point,
                    const std::string& u, const std::string& v) {
  const std::map<std::string, Formula> parameters = {
      {u, Formula::symbol(geometry::parameter_u)}, {v, Formula::symbol(geometry::parameter_v)}};
  std::vector<Scalar> components;
  for (const Formula& coordinate : point)
    components.push_back(scalar_of(symbolic::subst(coordinate, parameters), evaluator.numbers));
  if (e.text == "curve") return {CurveField{std::move(components)}};
  return {Field{e.text == "triangle_patch" ? Patch::Shape::triangle : Patch::Shape::square,
                std::move(components)}};
}

// The control points of a polynomial point: coefficient of u^a v^b spread over the
// Bernstein polynomials of the wanted degree.
Value formula_patch(Evaluator& evaluator, const Expression& e, const Scope& scope) {
  Scope inner{&scope, {}};
  const std::string u = evaluator.bind("u"), v = evaluator.bind("v");
  inner.values["u"] = {Scalar(Formula::symbol(u))};
  inner.values["v"] = {Scalar(Formula::symbol(v))};
  const auto add = [&](const std::string& name, const std::string& symbol) {
    if (!is_bound(scope, name) && !evaluator.globals.contains(name))
      inner.values[name] = {Scalar(Formula::symbol(symbol))};
  };
  if (e.text != "curve") add("s", u);
  add("t", e.text == "curve" ? u : v);
  const Point point = control_point(evaluator, e.children[0], inner);
  evaluator.release(u);
  evaluator.release(v);
  if (!std::ranges::all_of(point, [&](const Formula& f) {
        return is_polynomial_in(f, {u, v});
      }))
    return formula_field(evaluator, e, point, u, v);

  std::vector<symbolic::Coefficients> coordinates;
  int degree_u = 1, degree_v = 1, total = 1;
  for (const Formula& coordinate : point) {
    coordinates.push_back(symbolic::coefficients(coordinate, {u, v}, evaluator.numbers));
    for (const auto& [exponents, coefficient] : coordinates.back()) {
      degree_u = std::max(degree_u, exponents[0]);
      degree_v = std::max(degree_v, exponents[1]);
      total = std::max(total, exponents[0] + exponents[1]);
    }
  }
  if (total > 60) fail(e, "this degree is too large");
  const bool triangle = e.text == "triangle_patch", curve = e.text == "curve";
  if (curve && degree_v > 1) fail(e, "a curve is a formula in u alone");
  const int rows_count = triangle ? total : curve ? 0 : degree_v;
  Rows rows;
  for (int j = 0; j <= rows_count; ++j) {
    rows.emplace_back();
    for (int i = 0; i <= (triangle ? total - j : degree_u); ++i) {
      Point control;
      for (const auto& coordinate : coordinates) {
        Formula value = 0;
        for (const auto& [exponents, coefficient] : coordinate) {
          const int a = exponents[0], b = exponents[1];
          if (a > i || b > j) continue;
          const exact::Rational share =
              triangle ? binomial(i, a) * binomial(j, b) /
                             (binomial(total, a + b) * binomial(a + b, a))
                       : binomial(i, a) * binomial(j, b) /
                             (binomial(degree_u, a) * binomial(rows_count, b));
          value += coefficient * Formula(share);
        }
        control.push_back(std::move(value));
      }
      rows.back().push_back(std::move(control));
    }
  }
  // That these control points give back the formula is a statement of its own.
  Value net = curve ? Value{Curve{rows[0]}} : patch_of_rows(std::move(rows), triangle, e);
  const Formula at_u = Formula::symbol(u), at_v = Formula::symbol(v);
  const Point image = curve ? geometry::evaluate(*net.as<Curve>(), at_u)
                            : geometry::evaluate(*net.as<Patch>(), at_u, at_v);
  for (std::size_t i = 0; i < point.size(); ++i)
    evaluator.sides.push_back(symbolic::atom(symbolic::Zero{image[i] - point[i]},
                                             "the control points give the formula"));
  return net;
}

}  // namespace

Value Evaluator::net(const Expression& e, const Scope& scope) {
  if (e.text.starts_with("rational")) throw Unsupported("rational patches are not covered yet");
  if (e.kind == Kind::indexed) return labelled(*this, e, scope);
  if (e.kind == Kind::from) return formula_patch(*this, e, scope);
  return printed(*this, e, scope);
}

}  // namespace seam::claims
