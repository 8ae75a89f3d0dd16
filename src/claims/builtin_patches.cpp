// SPDX-License-Identifier: GPL-3.0-or-later
#include <numeric>

#include "claims/builtin.h"
#include "claims/chart.h"

namespace seam::claims {
namespace {

using geometry::Curve;
using geometry::Patch;
using symbolic::Point;

const Formula& u() {
  static const Formula symbol = Formula::symbol(geometry::parameter_u);
  return symbol;
}
const Formula& v() {
  static const Formula symbol = Formula::symbol(geometry::parameter_v);
  return symbol;
}

Vector scalars(const Call& call, const Point& point) {
  Vector result;
  for (const Formula& entry : point) result.push_back(scalar_of(entry, call.evaluator.numbers));
  return result;
}

Field field(const Call& call, Patch::Shape shape, const geometry::Quotient& quotient) {
  Numbers& numbers = call.evaluator.numbers;
  return {shape,
          {divide(scalar_of(quotient.numerator, numbers),
                  scalar_of(quotient.denominator, numbers), numbers)}};
}

Patch patch(const Call& call) {
  return call.get<Patch>(0, "a patch");
}

// The domain of a patch, or of a function on one; a function of two numbers is taken on the
// square.
Patch::Shape shape_of(const Value& value) {
  if (const auto* patch = value.as<Patch>()) return patch->shape();
  const auto* field = value.as<Field>();
  return field ? field->shape : Patch::Shape::square;
}

geometry::Chart chart(const Call& call, const Value& value) {
  if (auto found = chart_of(call.evaluator, value)) return *found;
  fail(call[0], "expected a patch, found " + description(value));
}

geometry::Chart chart_in_space(const Call& call, const Value& value) {
  geometry::Chart y = chart(call, value);
  if (y.derivative(0, 0).size() != 3)
    fail(call[0], "expected a patch in space, with three coordinates");
  return y;
}

Value derivative(const Call& call, int i, int j) {
  const Value value = call.value(0);
  if (const auto x = arc_of(call.evaluator, value))
    return {CurveField{scalars(call, x->derivative(i + j)), x->is_segment}};
  return {Field{shape_of(value), scalars(call, chart(call, value).derivative(i, j))}};
}

Value d1(const Call& call) {
  return derivative(call, 1, 0);
}
Value d2(const Call& call) {
  return derivative(call, 0, 1);
}
Value d(const Call& call) {
  const long i = call.integer(1), j = call.count() == 3 ? call.integer(2) : 0;
  if (i < 0 || j < 0 || i > 60 || j > 60) fail(call.at, "expected orders from 0 to 60");
  return derivative(call, static_cast<int>(i), static_cast<int>(j));
}

Value normal(const Call& call) {
  const Value value = call.value(0);
  return {Field{shape_of(value), scalars(call, geometry::normal(chart_in_space(call, value)))}};
}

Value gauss(const Call& call) {
  const Value value = call.value(0);
  if (const auto* surface = value.as<geometry::Surface>()) {
    SurfaceField result;
    for (const Patch& p : surface->patches)
      result.fields.push_back(field(call, p.shape(), geometry::gauss(p, u(), v())));
    return {result};
  }
  return {field(call, shape_of(value), geometry::gauss(chart_in_space(call, value)))};
}

Value control(const Call& call) {
  const Value value = call.value(0);
  const long i = call.integer(1);
  if (const auto* curve = value.as<Curve>()) {
    if (i < 0 || i > curve->degree()) fail(call[1], "no control point of this index");
    return vector_value(curve->control[i], call.evaluator.numbers);
  }
  const Patch p = patch(call);
  if (call.count() != 3) fail(call.at, "a control point of a patch has two indices");
  const long j = call.integer(2);
  if (j < 0 || j >= std::ssize(p.rows()) || i < 0 || i >= std::ssize(p.rows()[j]))
    fail(call.at, "no control point of these indices");
  return vector_value(p.control(static_cast<int>(i), static_cast<int>(j)),
                      call.evaluator.numbers);
}

Value elevate(const Call& call) {
  const Value value = call.value(0);
  if (const auto* curve = value.as<Curve>()) return {geometry::elevate(*curve)};
  return {geometry::elevate(patch(call))};
}

Value swap(const Call& call) {
  return {geometry::swap(patch(call))};
}

Value edge(const Call& call) {
  const Patch p = patch(call);
  const long k = call.integer(1);
  if (k < 1 || k > p.sides())
    fail(call[1], "expected an edge from 1 to " + std::to_string(p.sides()));
  return {geometry::edge(p, static_cast<int>(k))};
}

// f on every point of a patch, a curve, a point, or of all patches of a surface.
Value moved(const Call& call, const std::function<Point(const Point&)>& f) {
  const Value value = call.value(0);
  const auto checked = [&](const Point& point) {
    if (point.size() != 3) fail(call[0], "expected points with three coordinates");
    return f(point);
  };
  if (value.as<Vector>())
    return vector_value(checked(as_point(call.evaluator, value, call[0])),
                        call.evaluator.numbers);
  if (const auto* curve = value.as<Curve>()) {
    Curve image;
    for (const Point& point : curve->control) image.control.push_back(checked(point));
    return {image};
  }
  if (const auto* surface = value.as<geometry::Surface>()) {
    std::vector<Patch> images;
    for (const Patch& p : surface->patches) images.push_back(geometry::map(p, checked));
    return {glue(std::move(images), call[0], call.evaluator.numbers)};
  }
  return {geometry::map(patch(call), checked)};
}

Value reflect(const Call& call) {
  const Plane plane = call.get<Plane>(1, "a plane: 'plane n d'");
  const Point n = as_point(call.evaluator, {plane.normal}, call[1]);
  if (n.size() != 3) fail(call[1], "the normal of a plane has three coordinates");
  const Formula offset = as_formula(call.evaluator, {plane.offset}, call[1]);
  const Scalar share = divide(Scalar(1), scalar_of(geometry::norm2(n), call.evaluator.numbers),
                              call.evaluator.numbers);
  const Formula inverse = as_formula(call.evaluator, {share}, call[1]);
  return moved(
      call, [&](const Point& point) { return geometry::reflect(point, n, offset, inverse); });
}

// cos and sin of pi/n for n = 1, 2, 3, 4, 5, 6 and 10, by radicals.
std::pair<Formula, Formula> unit_angle(Numbers& numbers, long n) {
  const auto half = Formula(exact::Rational(1, 2)), quarter = Formula(exact::Rational(1, 4));
  Formula cosine = 0;
  switch (n) {
    case 1:
      return {Formula(-1), Formula(0)};
    case 2:
      return {Formula(0), Formula(1)};
    case 3:
      cosine = half;
      break;
    case 4:
      cosine = half * numbers.sqrt(2);
      break;
    case 5:
      cosine = quarter * (Formula(1) + numbers.sqrt(5));
      break;
    case 6:
      cosine = half * numbers.sqrt(3);
      break;
    case 10:
      cosine = half * numbers.sqrt(half * (Formula(5) + numbers.sqrt(5)));
      break;
    default:
      throw Unsupported("rotations by multiples of pi/n are covered for n = 1 to 6 and 10");
  }
  return {cosine, numbers.sqrt(Formula(1) - cosine * cosine)};
}

// The angle is a rational multiple of pi: `2*pi/3`.
Value rotate(const Call& call) {
  Scope inner{&call.scope, {}};
  const Formula pi = Formula::symbol("pi~");
  inner.values["pi"] = {Scalar(pi)};
  const Formula angle =
      as_formula(call.evaluator, call.evaluator.evaluate(call[2], inner), call[2]);
  const Formula share = symbolic::diff(angle, "pi~");
  if (!symbolic::is_number(share))
    fail(call[2], "expected a rational multiple of pi, such as 2*pi/3");
  const auto turn = call.evaluator.numbers.rational(share);
  const Formula rest = symbolic::subst(angle, {{"pi~", Formula(0)}});
  if (!turn || call.evaluator.numbers.sign(rest) != exact::Sign::zero)
    fail(call[2], "expected a rational multiple of pi, such as 2*pi/3");
  if (!turn->get_den().fits_sint_p() || !turn->get_num().fits_sint_p())
    fail(call[2], "this angle is too finely divided");
  const long n = turn->get_den().get_si();
  const auto [c, s] = unit_angle(call.evaluator.numbers, n);
  Formula cosine = 1, sine = 0;
  const long steps = ((turn->get_num().get_si() % (2 * n)) + 2 * n) % (2 * n);
  for (long k = 0; k < steps; ++k) {
    const Formula next = call.evaluator.numbers.normal_form(cosine * c - sine * s);
    sine = call.evaluator.numbers.normal_form(cosine * s + sine * c);
    cosine = next;
  }
  Point axis;
  for (const Scalar& entry : call.vector(1))
    axis.push_back(as_number(call.evaluator, {entry}, call[1]));
  if (axis.size() != 3) fail(call[1], "an axis has three coordinates");
  const geometry::Matrix matrix =
      geometry::rotation(axis, cosine, sine, call.evaluator.numbers);
  return moved(call, [&](const Point& point) { return geometry::operator*(matrix, point); });
}

}  // namespace

const Builtins& patch_builtins() {
  static const Builtins table = {
      {"D1", {1, 1, d1}},           {"D2", {1, 1, d2}},        {"D", {2, 3, d}},
      {"normal", {1, 1, normal}},   {"gauss", {1, 1, gauss}},  {"control", {2, 3, control}},
      {"elevate", {1, 1, elevate}}, {"swap", {1, 1, swap}},    {"edge", {2, 2, edge}},
      {"reflect", {2, 2, reflect}}, {"rotate", {3, 3, rotate}}};
  return table;
}

}  // namespace seam::claims
