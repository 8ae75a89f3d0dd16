// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "claims/builtin.h"

// What + - * / ^ mean for values that are not numbers: vectors and matrices as usual;
// a matrix or a number times a curve, patch, solid or surface moves it, a vector
// added shifts it; functions on patches combine point by point.

namespace seam::claims {
namespace {

using geometry::Curve;
using geometry::Matrix;
using geometry::Mesh;
using geometry::Patch;
using geometry::Surface;
using geometry::operator+;
using geometry::operator-;
using geometry::operator*;
using symbolic::Point;

using Motion = std::function<Point(const Point&)>;

// A value with every control point or vertex moved; nothing if it has none.
std::optional<Value> moved(Evaluator& evaluator, const Expression& at, const Value& value,
                           const Motion& motion) {
  const Motion reduced = [&](const Point& point) {
    Point image = motion(point);
    for (Formula& entry : image)
      if (symbolic::is_number(entry)) entry = evaluator.numbers.normal_form(entry);
    return image;
  };
  if (const auto* curve = value.as<Curve>()) {
    Curve image;
    for (const Point& point : curve->control) image.control.push_back(motion(point));
    return Value{image};
  }
  if (const auto* patch = value.as<Patch>()) return Value{geometry::map(*patch, motion)};
  if (const auto* mesh = value.as<Mesh>()) {
    Mesh image{mesh->vertices, mesh->faces};
    for (Point& point : image.vertices) point = motion(point);
    return Value{solid(std::move(image), at)};
  }
  if (const auto* surface = value.as<Surface>()) {
    std::vector<Patch> images;
    for (const Patch& patch : surface->patches) images.push_back(geometry::map(patch, reduced));
    return Value{glue(std::move(images), at, evaluator.numbers)};
  }
  return std::nullopt;
}

int dimension_of(const Value& value) {
  if (const auto* curve = value.as<Curve>()) return static_cast<int>(curve->control[0].size());
  if (const auto* patch = value.as<Patch>()) return patch->dimension();
  return 3;
}

Vector entrywise(const Expression& at, const Vector& a, const Vector& b, bool plus) {
  if (a.size() != b.size())
    fail(at, "vectors of " + std::to_string(a.size()) + " and " + std::to_string(b.size()) +
                 " entries do not combine");
  Vector result;
  for (std::size_t i = 0; i < a.size(); ++i) result.push_back(plus ? a[i] + b[i] : a[i] - b[i]);
  return result;
}

Vector scaled(const Scalar& factor, const Vector& v) {
  Vector result;
  for (const Scalar& entry : v) result.push_back(factor * entry);
  return result;
}

Scalar inner(const Expression& at, const Vector& a, const Vector& b) {
  if (a.size() != b.size())
    fail(at, "a row of " + std::to_string(a.size()) + " entries meets a column of " +
                 std::to_string(b.size()));
  Scalar result;
  for (std::size_t i = 0; i < a.size(); ++i) result = result + a[i] * b[i];
  return result;
}

Vector column(const MatrixValue& m, std::size_t j) {
  Vector result;
  for (const Vector& row : m.rows) result.push_back(row[j]);
  return result;
}

std::optional<Value> sum_of(Evaluator& evaluator, const Expression& at, const Value& a,
                            const Value& b, bool plus) {
  if (a.as<Scalar>() && b.as<Scalar>())
    return Value{plus ? *a.as<Scalar>() + *b.as<Scalar>() : *a.as<Scalar>() - *b.as<Scalar>()};
  if (a.as<Vector>() && b.as<Vector>())
    return Value{entrywise(at, *a.as<Vector>(), *b.as<Vector>(), plus)};
  if (const auto* m = a.as<MatrixValue>(), *n = b.as<MatrixValue>(); m && n) {
    if (m->rows.size() != n->rows.size()) fail(at, "these matrices differ in size");
    MatrixValue result;
    for (std::size_t i = 0; i < m->rows.size(); ++i)
      result.rows.push_back(entrywise(at, m->rows[i], n->rows[i], plus));
    return Value{result};
  }
  if (const auto* f = a.as<Field>(), *g = b.as<Field>(); f && g && f->shape == g->shape)
    return Value{Field{f->shape, entrywise(at, f->components, g->components, plus)}};
  if (const auto* f = a.as<Field>(); f && (b.as<Scalar>() || b.as<Vector>())) {
    const Vector other = b.as<Scalar>() ? Vector{*b.as<Scalar>()} : *b.as<Vector>();
    return Value{Field{f->shape, entrywise(at, f->components, other, plus)}};
  }
  if (b.as<Vector>()) {
    const Point shift = as_point(evaluator, b, at);
    const Motion motion = [&](const Point& point) -> Point {
      if (point.size() != shift.size()) fail(at, "this shift is not of the dimension of space");
      return plus ? point + shift : point - shift;
    };
    return moved(evaluator, at, a, motion);
  }
  return std::nullopt;
}

Value scaled_extremum(Evaluator& evaluator, const Expression& at, const Extremum& extremum,
                      const Scalar& factor) {
  const auto sign = evaluator.numbers.sign(as_number(evaluator, {factor}, at));
  Extremum result = extremum;
  if (sign == exact::Sign::negative) result.maximum = !result.maximum;
  for (auto& part : result.parts) part.value = factor * part.value;
  return {result};
}

std::optional<Value> product_of(Evaluator& evaluator, const Expression& at, const Value& a,
                                const Value& b) {
  if (const auto* s = a.as<Scalar>()) {
    if (b.as<Scalar>()) return Value{*s * *b.as<Scalar>()};
    if (b.as<Vector>()) return Value{scaled(*s, *b.as<Vector>())};
    if (const auto* f = b.as<Field>()) return Value{Field{f->shape, scaled(*s, f->components)}};
    if (const auto* e = b.as<Extremum>()) return scaled_extremum(evaluator, at, *e, *s);
    if (const auto* m = b.as<MatrixValue>()) {
      MatrixValue result;
      for (const Vector& row : m->rows) result.rows.push_back(scaled(*s, row));
      return Value{result};
    }
    const Formula factor = as_formula(evaluator, a, at);
    return moved(evaluator, at, b, [&](const Point& point) { return factor * point; });
  }
  if (b.as<Scalar>()) return product_of(evaluator, at, b, a);
  if (const auto* m = a.as<MatrixValue>()) {
    if (const auto* v = b.as<Vector>()) {
      Vector result;
      for (const Vector& row : m->rows) result.push_back(inner(at, row, *v));
      return Value{result};
    }
    if (const auto* n = b.as<MatrixValue>()) {
      MatrixValue result;
      for (const Vector& row : m->rows) {
        result.rows.emplace_back();
        for (std::size_t j = 0; j < n->rows.front().size(); ++j)
          result.rows.back().push_back(inner(at, row, column(*n, j)));
      }
      return Value{result};
    }
    if (static_cast<int>(m->rows.front().size()) != dimension_of(b))
      fail(at, "this matrix does not fit the dimension of space");
    const Matrix matrix = as_matrix(evaluator, a, at);
    return moved(evaluator, at, b, [&](const Point& point) { return matrix * point; });
  }
  if (const auto* n = b.as<MatrixValue>(); n && a.as<Vector>()) {
    Vector result;
    for (std::size_t j = 0; j < n->rows.front().size(); ++j)
      result.push_back(inner(at, *a.as<Vector>(), column(*n, j)));
    return Value{result};
  }
  if (const auto* f = a.as<Field>(), *g = b.as<Field>();
      f && g && f->shape == g->shape && f->components.size() == 1)
    return Value{Field{f->shape, scaled(f->components[0], g->components)}};
  return std::nullopt;
}

std::optional<Value> quotient_of(Evaluator& evaluator, const Expression& at, const Value& a,
                                 const Value& b) {
  if (b.as<Scalar>()) {
    const Scalar inverse = divide(Scalar(1), *b.as<Scalar>(), evaluator.numbers);
    if (a.as<Scalar>())
      return Value{divide(*a.as<Scalar>(), *b.as<Scalar>(), evaluator.numbers)};
    return product_of(evaluator, at, {inverse}, a);
  }
  if (const auto* f = a.as<Field>(), *g = b.as<Field>();
      f && g && f->shape == g->shape && g->components.size() == 1) {
    const Scalar inverse = divide(Scalar(1), g->components[0], evaluator.numbers);
    return Value{Field{f->shape, scaled(inverse, f->components)}};
  }
  return std::nullopt;
}

std::optional<Value> power_of(Evaluator& evaluator, const Expression& at, const Value& a,
                              const Value& b) {
  if (a.as<Scalar>() && b.as<Scalar>() && !is_number(*b.as<Scalar>()))
    if (auto raised = integer_power(evaluator, *a.as<Scalar>(), *b.as<Scalar>()))
      return Value{*raised};
  const auto exponent = evaluator.numbers.rational(as_number(evaluator, b, at));
  if (!exponent) fail(at, "an exponent must be rational");
  if (exponent->get_den() == 2 && a.as<Scalar>()) {
    const Value root{Scalar(evaluator.numbers.sqrt(as_number(evaluator, a, at)))};
    return power_of(evaluator, at, root,
                    {Scalar(Formula(exact::Rational(exponent->get_num())))});
  }
  if (exponent->get_den() != 1) fail(at, "an exponent must be an integer or a half");
  if (abs(exponent->get_num()) > 1000) fail(at, "an exponent of more than 1000 is too large");
  const long n = exponent->get_num().get_si();
  if (a.as<Scalar>()) return Value{power(*a.as<Scalar>(), n, evaluator.numbers)};
  if (const auto* f = a.as<Field>(); f && f->components.size() == 1)
    return Value{Field{f->shape, {power(f->components[0], n, evaluator.numbers)}}};
  return std::nullopt;
}

}  // namespace

Value arithmetic(Evaluator& evaluator, const Expression& at, const std::string& operation,
                 const Value& left, const Value& right) {
  Value a = left, b = right;
  const bool scales = operation == "*" || operation == "/";
  if (a.as<Extremum>() && !(scales && b.as<Scalar>())) a = evaluator.resolved(a, at);
  if (b.as<Extremum>() && !(operation == "*" && a.as<Scalar>())) b = evaluator.resolved(b, at);

  std::optional<Value> result;
  if (operation == "+" || operation == "-")
    result = sum_of(evaluator, at, a, b, operation == "+");
  else if (operation == "*")
    result = product_of(evaluator, at, a, b);
  else if (operation == "/")
    result = quotient_of(evaluator, at, a, b);
  else
    result = power_of(evaluator, at, a, b);
  if (!result)
    fail(at,
         "'" + operation + "' does not combine " + description(a) + " and " + description(b));
  return *result;
}

Value negated(Evaluator& evaluator, const Expression& at, const Value& value) {
  return arithmetic(evaluator, at, "*", {Scalar(-1)}, value);
}

}  // namespace seam::claims
