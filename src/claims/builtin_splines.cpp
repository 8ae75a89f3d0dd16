// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/builtin.h"
#include "symbolic/coefficients.h"

// Blending functions: the row of a matrix, times the powers of u, the highest first. A curve or
// a patch that they blend is put into Bernstein form, b_k = sum C(k, l)/C(n, l) c_l; that it is
// the blended one is a statement of its own.

namespace seam::claims {
namespace {

using symbolic::Point;

constexpr std::size_t most_functions = 30;

Formula power_of(const std::string& parameter, std::size_t exponent) {
  return symbolic::power(Formula::symbol(parameter), static_cast<int>(exponent));
}

Scalar function(const Vector& row, const std::string& parameter) {
  Scalar result;
  for (std::size_t j = 0; j < row.size(); ++j)
    result = result + row[j] * Scalar(power_of(parameter, row.size() - 1 - j));
  return result;
}

MatrixValue basis(const Call& call, std::size_t i) {
  const auto matrix = call.get<MatrixValue>(i, "a matrix with a row for each function");
  if (matrix.rows.size() > most_functions || matrix.rows.front().size() > most_functions)
    fail(call[i], "more than " + std::to_string(most_functions) + " rows or columns");
  return matrix;
}

Value blending(const Call& call) {
  List functions;
  for (const Vector& row : basis(call, 0).rows)
    functions.items.push_back({CurveField{{function(row, geometry::parameter_u)}}});
  return {functions};
}

// By function and index: the Bernstein coefficients.
std::vector<std::vector<Formula>> bernstein(const MatrixValue& matrix) {
  const auto degree = static_cast<unsigned>(matrix.rows.front().size() - 1);
  const auto choose = [](unsigned n, unsigned k) {
    exact::Integer value;
    mpz_bin_uiui(value.get_mpz_t(), n, k);
    return exact::Rational(value);
  };
  std::vector<std::vector<Formula>> result;
  for (const Vector& row : matrix.rows) {
    result.emplace_back();
    for (unsigned k = 0; k <= degree; ++k) {
      Scalar sum;
      for (unsigned l = 0; l <= k; ++l)
        sum = sum + Scalar(Formula(choose(k, l) / choose(degree, l))) * row[degree - l];
      result.back().push_back(formula_of(sum));
    }
  }
  return result;
}

using Net = std::vector<std::vector<Point>>;

// A row of points, or rows of them.
Net net(const Call& call, std::size_t i) {
  Net result;
  const Value value = call.value(i);
  const auto rows = as_items(call.evaluator, value, call[i]);
  const bool is_row = !rows.empty() && rows.front().as<Vector>() != nullptr;
  for (const Value& row : is_row ? std::vector<Value>{value} : rows)
    result.push_back(as_points(call.evaluator, row, call[i]));
  if (result.empty() || result.front().empty()) fail(call[i], "a net without points");
  for (const auto& row : result)
    if (row.size() != result.front().size() ||
        row.front().size() != result.front().front().size())
      fail(call[i], "the rows of a net are of one length, its points of one dimension");
  return result;
}

// sum of weights[i] points[i]
Point blended(const std::vector<Formula>& weights, const std::vector<Point>& points) {
  Point result(points.front().size(), Formula(0));
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t c = 0; c < result.size(); ++c) result[c] += weights[i] * points[i][c];
  return result;
}

std::vector<Formula> column(const std::vector<std::vector<Formula>>& rows, std::size_t k) {
  std::vector<Formula> result;
  for (const auto& row : rows) result.push_back(row[k]);
  return result;
}

std::vector<Formula> functions(const MatrixValue& matrix, const std::string& parameter) {
  std::vector<Formula> result;
  for (const Vector& row : matrix.rows) result.push_back(formula_of(function(row, parameter)));
  return result;
}

void state_equal(Evaluator& evaluator, const Point& a, const Point& b) {
  for (std::size_t c = 0; c < a.size(); ++c)
    evaluator.sides.push_back(symbolic::atom(symbolic::Zero{a[c] - b[c]},
                                             "the control points give the blended points"));
}

// The points of each row blended: one a row.
std::vector<Point> along_rows(const Net& points, const std::vector<Formula>& weights) {
  std::vector<Point> result;
  for (const auto& row : points) result.push_back(blended(weights, row));
  return result;
}

Value tensor(const Call& call) {
  const std::size_t last = call.count() - 1;
  const MatrixValue along_u = basis(call, 0), along_v = basis(call, last - 1);
  const Net points = net(call, last);
  if (along_u.rows.front().size() < 2 || along_v.rows.front().size() < 2)
    fail(call[0], "constant functions blend no curve");
  if (points.front().size() != along_u.rows.size())
    fail(call[last], "a row of " + std::to_string(points.front().size()) + " points for " +
                         std::to_string(along_u.rows.size()) + " functions");
  const auto in_u = bernstein(along_u), in_v = bernstein(along_v);
  const Formula u = Formula::symbol(geometry::parameter_u);
  const Formula v = Formula::symbol(geometry::parameter_v);
  const auto sums = along_rows(points, functions(along_u, geometry::parameter_u));
  if (points.size() == 1) {
    if (last == 2) fail(call[last], "a curve has one set of functions");
    geometry::Curve curve;
    for (std::size_t k = 0; k < in_u.front().size(); ++k)
      curve.control.push_back(blended(column(in_u, k), points.front()));
    state_equal(call.evaluator, geometry::evaluate(curve, u), sums.front());
    return {curve};
  }
  if (points.size() != along_v.rows.size())
    fail(call[last], std::to_string(points.size()) + " rows of points for " +
                         std::to_string(along_v.rows.size()) + " functions");
  Net control(in_v.front().size());
  for (std::size_t k = 0; k < in_u.front().size(); ++k) {
    const std::vector<Point> across = along_rows(points, column(in_u, k));
    for (std::size_t l = 0; l < control.size(); ++l)
      control[l].push_back(blended(column(in_v, l), across));
  }
  const geometry::Patch patch = geometry::Patch::square(std::move(control));
  state_equal(call.evaluator, geometry::evaluate(patch, u, v),
              blended(functions(along_v, geometry::parameter_v), sums));
  return {patch};
}

}  // namespace

const Builtins& spline_builtins() {
  static const Builtins table = {{"blending", {1, 1, blending}}, {"tensor", {2, 3, tensor}}};
  return table;
}

}  // namespace seam::claims
