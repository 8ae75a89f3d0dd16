// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/linear.h"

#include <utility>

#include "bernstein/critical.h"
#include "exact/contract.h"

namespace seam::prove {

using exact::Polynomial;

namespace {

template <class T>
std::vector<std::vector<T>> transposed(const std::vector<std::vector<T>>& rows) {
  std::vector<std::vector<T>> result(rows.front().size());
  for (const auto& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) result[i].push_back(row[i]);
  return result;
}

}  // namespace

std::vector<double> barycentric(const std::vector<std::vector<double>>& corners,
                                const std::vector<double>& point) {
  double total = 0;
  for (const double p : point) total += p;
  std::vector<double> unit;
  for (const double p : point) unit.push_back(p / total);
  return bernstein::solve(transposed(corners), unit);
}

std::vector<Polynomial> barycentric(const std::vector<std::vector<Polynomial>>& corners,
                                    const std::vector<Polynomial>& point) {
  auto m = transposed(corners);
  std::vector<Polynomial> right = point;
  const std::size_t n = right.size();
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    while (pivot < n && m[pivot][c].is_zero()) ++pivot;
    exact::require(pivot < n, "barycentric: dependent corners");
    std::swap(m[pivot], m[c]);
    std::swap(right[pivot], right[c]);
    const Polynomial scale = exact::inverse(m[c][c]);
    for (std::size_t k = c; k < n; ++k) m[c][k] = scale * m[c][k];
    right[c] = scale * right[c];
    for (std::size_t r = 0; r < n; ++r) {
      if (r == c || m[r][c].is_zero()) continue;
      const Polynomial factor = m[r][c];
      for (std::size_t k = c; k < n; ++k) m[r][k] = m[r][k] - factor * m[c][k];
      right[r] = right[r] - factor * right[c];
    }
  }
  return right;
}

}  // namespace seam::prove
