// SPDX-License-Identifier: GPL-3.0-or-later
#include "claims/builtin.h"

namespace seam::claims {
namespace {

// Of a vector, or of a function on a patch.
Vector components(const Call& call, std::size_t i) {
  const Value value = call.value(i);
  if (const auto* field = value.as<Field>()) return field->components;
  return as_vector(call.evaluator, value, call[i]);
}

Vector pair_checked(const Call& call, std::size_t i, std::size_t size) {
  Vector v = components(call, i);
  if (size != 0 && v.size() != size)
    fail(call[i], "expected a vector of " + std::to_string(size) + ", found a vector of " +
                      std::to_string(v.size()));
  return v;
}

Scalar inner(const Vector& a, const Vector& b) {
  Scalar total;
  for (std::size_t i = 0; i < a.size(); ++i) total = total + a[i] * b[i];
  return total;
}

// Functions on patches go through point by point: the result is one if an operand is.
Value like(const Call& call, Vector values) {
  const Field* first = nullptr;
  std::vector<Value> arguments;
  for (std::size_t i = 0; i < call.count(); ++i) arguments.push_back(call.value(i));
  for (const Value& argument : arguments) {
    const auto* field = argument.as<Field>();
    if (first && field && field->shape != first->shape)
      fail(call.at, "these functions live on different domains");
    if (field) first = field;
  }
  if (first) return {Field{first->shape, std::move(values)}};
  if (values.size() == 1) return {values.front()};
  return {values};
}

Value dot(const Call& call) {
  const Vector a = components(call, 0);
  return like(call, {inner(a, pair_checked(call, 1, a.size()))});
}

Value cross(const Call& call) {
  const Vector a = pair_checked(call, 0, 3), b = pair_checked(call, 1, 3);
  return like(
      call, {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]});
}

Value norm2(const Call& call) {
  const Vector a = components(call, 0);
  return like(call, {inner(a, a)});
}

Value norm(const Call& call) {
  const Vector a = components(call, 0);
  return like(call, {nth_root(inner(a, a), 2, call.evaluator.numbers)});
}

// Laplace along the first row: at most 6 x 6.
Scalar determinant(const std::vector<Vector>& rows) {
  if (rows.size() == 1) return rows[0][0];
  Scalar total;
  for (std::size_t j = 0; j < rows.size(); ++j) {
    std::vector<Vector> minor;
    for (std::size_t i = 1; i < rows.size(); ++i) {
      minor.emplace_back();
      for (std::size_t k = 0; k < rows.size(); ++k)
        if (k != j) minor.back().push_back(rows[i][k]);
    }
    const Scalar term = rows[0][j] * determinant(minor);
    total = j % 2 == 0 ? total + term : total - term;
  }
  return total;
}

// det(M), det(a, b, c) and det[a, b, c] are the same.
Value det(const Call& call) {
  std::vector<Vector> rows;
  const Value first = call.value(0);
  if (call.count() > 1) {
    for (std::size_t i = 0; i < call.count(); ++i) rows.push_back(components(call, i));
  } else if (const auto* matrix = first.as<MatrixValue>()) {
    rows = matrix->rows;
  } else {
    for (const Value& item : as_items(call.evaluator, first, call[0]))
      rows.push_back(as_vector(call.evaluator, item, call[0]));
  }
  for (const Vector& row : rows)
    if (row.size() != rows.size())
      fail(call.at, "a determinant needs " + std::to_string(rows.size()) + " vectors of " +
                        std::to_string(rows.size()) + ", found one of " +
                        std::to_string(row.size()));
  if (rows.size() > 6) throw Unsupported("determinants of more than 6 rows are not covered");
  return like(call, {determinant(rows)});
}

MatrixValue matrix(const Call& call) {
  return call.get<MatrixValue>(0, "a matrix");
}

MatrixValue transposed(const MatrixValue& m) {
  MatrixValue result;
  for (std::size_t j = 0; j < m.rows[0].size(); ++j) {
    result.rows.emplace_back();
    for (const Vector& row : m.rows) result.rows.back().push_back(row[j]);
  }
  return result;
}

Value transpose(const Call& call) {
  return {transposed(matrix(call))};
}

// By cofactors.
Value inverse(const Call& call) {
  const MatrixValue m = matrix(call);
  const std::size_t n = m.rows.size();
  if (m.rows[0].size() != n || n > 5)
    fail(call[0], "expected a square matrix of at most 5 rows");
  const Scalar d = determinant(m.rows);
  MatrixValue result;
  for (std::size_t i = 0; i < n; ++i) {
    result.rows.emplace_back();
    for (std::size_t j = 0; j < n; ++j) {
      std::vector<Vector> minor;
      for (std::size_t r = 0; r < n; ++r) {
        if (r == j) continue;
        minor.emplace_back();
        for (std::size_t c = 0; c < n; ++c)
          if (c != i) minor.back().push_back(m.rows[r][c]);
      }
      const Scalar cofactor = n == 1 ? Scalar(1) : determinant(minor);
      result.rows.back().push_back(
          divide((i + j) % 2 == 0 ? cofactor : -cofactor, d, call.evaluator.numbers));
    }
  }
  return {result};
}

Value identity(const Call& call) {
  const long n = call.integer(0);
  if (n < 1 || n > 10) fail(call[0], "expected a size from 1 to 10");
  MatrixValue result;
  for (long i = 0; i < n; ++i) {
    result.rows.emplace_back(n, Scalar(0));
    result.rows.back()[i] = Scalar(1);
  }
  return {result};
}

Value rows(const Call& call) {
  List list;
  for (const Vector& row : matrix(call).rows) list.items.push_back({row});
  return {list};
}

Value columns(const Call& call) {
  List list;
  for (const Vector& column : transposed(matrix(call)).rows) list.items.push_back({column});
  return {list};
}

}  // namespace

const Builtins& vector_builtins() {
  static const Builtins table = {{"dot", {2, 2, dot}},         {"cross", {2, 2, cross}},
                                 {"norm2", {1, 1, norm2}},     {"norm", {1, 1, norm}},
                                 {"det", {1, 6, det}},         {"transpose", {1, 1, transpose}},
                                 {"inverse", {1, 1, inverse}}, {"identity", {1, 1, identity}},
                                 {"rows", {1, 1, rows}},       {"columns", {1, 1, columns}}};
  return table;
}

}  // namespace seam::claims
