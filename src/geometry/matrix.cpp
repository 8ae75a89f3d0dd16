// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/matrix.h"

namespace seam::geometry {

Point operator*(const Matrix& m, const Point& x) {
  Point result;
  for (const Point& row : m.rows) result.push_back(dot(row, x));
  return result;
}

Matrix operator*(const Matrix& a, const Matrix& b) {
  const Matrix columns = transpose(b);
  Matrix result;
  for (const Point& row : a.rows) result.rows.push_back(columns * row);
  return result;
}

Matrix transpose(const Matrix& m) {
  Matrix result;
  if (m.rows.empty()) return result;
  result.rows.resize(m.rows[0].size());
  for (const Point& row : m.rows)
    for (std::size_t column = 0; column < row.size(); ++column)
      result.rows.at(column).push_back(row[column]);
  return result;
}

Matrix identity(int n) {
  Matrix result;
  for (int row = 0; row < n; ++row) {
    result.rows.emplace_back(n);
    result.rows.back()[row] = 1;
  }
  return result;
}

}  // namespace seam::geometry
