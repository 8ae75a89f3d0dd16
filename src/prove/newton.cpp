// SPDX-License-Identifier: GPL-3.0-or-later
#include "prove/newton.h"

#include <algorithm>
#include <cmath>

// It guesses; nothing rests on it. A fixed number of rounds.

namespace seam::prove {

namespace {

constexpr int most_rounds = 40;
constexpr double close = 1e-13;
constexpr double far = 1e9;

using Matrix = std::vector<std::vector<double>>;

}  // namespace

Matrix inverse_jacobian(const std::vector<bernstein::Sketch>& equations,
                        const std::vector<double>& point) {
  Matrix matrix;
  for (const auto& f : equations) matrix.push_back(f.jet(point).gradient);
  const std::size_t n = matrix.size();
  Matrix inverse(n, std::vector<double>(n));
  for (std::size_t k = 0; k < n; ++k) {
    std::vector<double> unit(n, 0.0);
    unit[k] = 1;
    const auto column = bernstein::solve(matrix, unit);
    if (column.empty()) return {};
    for (std::size_t i = 0; i < n; ++i) {
      if (!(std::abs(column[i]) < far)) return {};
      inverse[i][k] = column[i];
    }
  }
  return inverse;
}

std::vector<double> newton(const std::vector<bernstein::Sketch>& equations,
                           std::vector<double> from) {
  for (int round = 0; round < most_rounds; ++round) {
    Matrix slopes;
    std::vector<double> values;
    for (const auto& f : equations) {
      auto jet = f.jet(from);
      values.push_back(jet.value);
      slopes.push_back(std::move(jet.gradient));
    }
    const auto step = bernstein::solve(std::move(slopes), std::move(values));
    if (step.empty()) return {};
    double length = 0, size = 1;
    for (std::size_t i = 0; i < step.size(); ++i) {
      from[i] -= step[i];
      length = std::max(length, std::abs(step[i]));
      size = std::max(size, std::abs(from[i]));
    }
    if (!(size < far)) return {};
    if (length <= close * size) return from;
  }
  return {};
}

}  // namespace seam::prove
