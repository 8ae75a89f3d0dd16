// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "claims/evaluate.h"

namespace seam::claims {
namespace {

std::string counted(std::size_t n, const char* what) {
  return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

struct Describe {
  std::string operator()(const Scalar& s) const {
    return is_number(s) ? "a number" : "a function";
  }
  std::string operator()(const Vector& v) const {
    return "a vector of " + std::to_string(v.size());
  }
  std::string operator()(const MatrixValue& m) const {
    return "a matrix of " + counted(m.rows.size(), "row") + " and " +
           counted(m.rows.front().size(), "column");
  }
  std::string operator()(const List& l) const {
    return "a list of " + std::to_string(l.items.size());
  }
  std::string operator()(const geometry::Curve&) const { return "a curve"; }
  std::string operator()(const geometry::Patch& p) const {
    return p.shape() == geometry::Patch::Shape::triangle ? "a triangle patch" : "a quad patch";
  }
  std::string operator()(const Field&) const { return "a function on a patch"; }
  std::string operator()(const CurveField&) const { return "a function on a curve"; }
  std::string operator()(const SurfaceField&) const { return "a function on a surface"; }
  std::string operator()(const geometry::Mesh&) const { return "a solid"; }
  std::string operator()(const AnyMesh&) const { return "an arbitrary mesh"; }
  std::string operator()(const IteratedMesh&) const {
    return "a mesh truncated again and again";
  }
  std::string operator()(const geometry::Surface&) const { return "a surface"; }
  std::string operator()(const Extremum&) const { return "an extremum"; }
  std::string operator()(const Minimax&) const { return "a best value of a parameter"; }
  std::string operator()(const Plane&) const { return "a plane"; }
  std::string operator()(const Region&) const { return "a domain"; }
  std::string operator()(const Function&) const { return "a function"; }
};

[[noreturn]] void expected(const char* what, const Value& found, const Expression& at) {
  fail(at, std::string("expected ") + what + ", found " + description(found));
}

}  // namespace

std::string description(const Value& value) {
  return std::visit(Describe{}, value.content);
}

void fail(const Expression& at, std::string message, std::string hint) {
  throw Problem({at.span, std::move(message), std::move(hint)});
}

Scalar as_scalar(Evaluator& evaluator, const Value& value, const Expression& at) {
  if (const auto* scalar = value.as<Scalar>()) return *scalar;
  if (value.as<Extremum>()) return as_scalar(evaluator, evaluator.resolved(value, at), at);
  expected("a number", value, at);
}

Formula as_formula(Evaluator& evaluator, const Value& value, const Expression& at) {
  const Scalar scalar = as_scalar(evaluator, value, at);
  if (!scalar.denominator.is(1) && symbolic::is_number(scalar.numerator) &&
      symbolic::is_number(scalar.denominator))
    return scalar.numerator * evaluator.numbers.inverse(scalar.denominator);
  return formula_of(scalar);
}

Formula as_number(Evaluator& evaluator, const Value& value, const Expression& at) {
  const Formula formula = as_formula(evaluator, value, at);
  if (!symbolic::is_number(formula)) {
    const std::string variable = *symbolic::variables(formula).begin();
    if (evaluator.integers.general.contains(variable))
      throw Unsupported("a number is wanted where an integer parameter stands");
    fail(at, "expected a number, found a function of '" + variable + "'");
  }
  return formula;
}

long as_integer(Evaluator& evaluator, const Value& value, const Expression& at) {
  const auto rational = evaluator.numbers.rational(as_number(evaluator, value, at));
  if (!rational || rational->get_den() != 1) fail(at, "expected an integer");
  if (!rational->get_num().fits_sint_p()) fail(at, "this integer is too large here");
  return rational->get_num().get_si();
}

Vector as_vector(Evaluator& evaluator, const Value& value, const Expression& at) {
  if (const auto* vector = value.as<Vector>()) return *vector;
  if (const auto* list = value.as<List>()) {
    Vector entries;
    for (const Value& item : list->items) entries.push_back(as_scalar(evaluator, item, at));
    return entries;
  }
  expected("a vector", value, at);
}

symbolic::Point as_point(Evaluator& evaluator, const Value& value, const Expression& at) {
  symbolic::Point point;
  for (const Scalar& entry : as_vector(evaluator, value, at))
    point.push_back(as_formula(evaluator, Value{entry}, at));
  return point;
}

std::vector<Value> as_items(Evaluator&, const Value& value, const Expression& at) {
  if (const auto* list = value.as<List>()) return list->items;
  if (const auto* vector = value.as<Vector>()) {
    std::vector<Value> items;
    for (const Scalar& entry : *vector) items.push_back({entry});
    return items;
  }
  if (const auto* matrix = value.as<MatrixValue>()) {
    std::vector<Value> items;
    for (const Vector& row : matrix->rows) items.push_back({row});
    return items;
  }
  expected("a list", value, at);
}

std::vector<symbolic::Point> as_points(Evaluator& evaluator, const Value& value,
                                       const Expression& at) {
  std::vector<symbolic::Point> points;
  for (const Value& item : as_items(evaluator, value, at))
    points.push_back(as_point(evaluator, item, at));
  for (const auto& point : points)
    if (point.size() != points.front().size())
      fail(at, "these points are not all of one dimension");
  return points;
}

geometry::Matrix as_matrix(Evaluator& evaluator, const Value& value, const Expression& at) {
  geometry::Matrix matrix;
  const auto* rows = value.as<MatrixValue>();
  if (!rows) expected("a matrix", value, at);
  for (const Vector& row : rows->rows) matrix.rows.push_back(as_point(evaluator, {row}, at));
  return matrix;
}

Value vector_value(const symbolic::Point& point, Numbers& numbers) {
  Vector vector;
  for (const Formula& entry : point) vector.push_back(scalar_of(entry, numbers));
  return {vector};
}

exact::Rational decimal(const std::string& digits) {
  const auto point = digits.find('.');
  if (point == std::string::npos) return exact::Rational(digits, 10);
  std::string all = digits;
  all.erase(point, 1);
  exact::Integer scale;
  mpz_ui_pow_ui(scale.get_mpz_t(), 10, digits.size() - point - 1);
  exact::Rational value(exact::Integer(all, 10), scale);
  value.canonicalize();
  return value;
}

}  // namespace seam::claims
