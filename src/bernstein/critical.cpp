// SPDX-License-Identifier: GPL-3.0-or-later
#include "bernstein/critical.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "exact/field.h"

// At a critical point of n / d, with r = n / d there, the gradient of n - r d vanishes and its
// Hessian is d times that of n / d. So Newton's step for n - r d, r taken anew each time,
// converges like Newton's method.

namespace seam::bernstein {

Sketch::Sketch(const exact::Polynomial& f)
    : variables_(f.ring().variables().size()), degrees_(variables_, 0) {
  const auto numerators = f.numerators();
  for (const auto& [exponents, number] : numerators.terms) {
    const exact::Polynomial c = f.ring().number(number, numerators.denominator);
    terms_.push_back({exponents, exact::ball(c).middle});
    for (std::size_t i = 0; i < variables_; ++i)
      degrees_[i] = std::max(degrees_[i], exponents[i]);
  }
}

Sketch::Jet Sketch::jet(const std::vector<double>& at) const {
  // powers[i][e]: x^e, its first and its second derivative
  struct Power {
    double value, first, second;
  };
  std::vector<std::vector<Power>> powers(variables_);
  for (std::size_t i = 0; i < variables_; ++i) {
    double x0 = 1, x1 = 0, x2 = 0;  // x^e, x^(e-1), x^(e-2)
    for (int e = 0; e <= degrees_[i]; ++e) {
      powers[i].push_back({x0, e * x1, e * (e - 1) * x2});
      x2 = x1;
      x1 = x0;
      x0 *= at[i];
    }
  }
  Jet jet{0, std::vector<double>(variables_, 0),
          std::vector<std::vector<double>>(variables_, std::vector<double>(variables_, 0))};
  for (const Term& term : terms_) {
    const auto power = [&](std::size_t i) -> const Power& {
      return powers[i][term.exponents[i]];
    };
    double value = term.coefficient;
    for (std::size_t i = 0; i < variables_; ++i) value *= power(i).value;
    jet.value += value;
    for (std::size_t a = 0; a < variables_; ++a) {
      if (term.exponents[a] == 0) continue;
      double first = term.coefficient;
      for (std::size_t i = 0; i < variables_; ++i)
        first *= i == a ? power(i).first : power(i).value;
      jet.gradient[a] += first;
      for (std::size_t b = a; b < variables_; ++b) {
        double second = term.coefficient;
        for (std::size_t i = 0; i < variables_; ++i) {
          const bool is_a = i == a, is_b = i == b;
          second *= is_a && is_b   ? power(i).second
                    : is_a || is_b ? power(i).first
                                   : power(i).value;
        }
        jet.hessian[a][b] += second;
        if (a != b) jet.hessian[b][a] += second;
      }
    }
  }
  return jet;
}

double Sketch::value(const std::vector<double>& at) const {
  std::vector<std::vector<double>> powers(variables_, {1});
  for (std::size_t i = 0; i < variables_; ++i)
    for (int e = 0; e < degrees_[i]; ++e) powers[i].push_back(powers[i].back() * at[i]);
  double sum = 0;
  for (const Term& term : terms_) {
    double value = term.coefficient;
    for (std::size_t i = 0; i < variables_; ++i) value *= powers[i][term.exponents[i]];
    sum += value;
  }
  return sum;
}

std::vector<double> critical_point(const Sketch& numerator, const Sketch* denominator,
                                   std::vector<double> x,
                                   const std::vector<Direction>& directions) {
  const std::size_t n = x.size(), m = directions.size();
  double last_step = 1;
  for (int round = 0; round < 60; ++round) {
    Sketch::Jet f = numerator.jet(x);
    if (denominator) {
      const Sketch::Jet d = denominator->jet(x);
      const double ratio = f.value / d.value;
      for (std::size_t i = 0; i < n; ++i) {
        f.gradient[i] -= ratio * d.gradient[i];
        for (std::size_t j = 0; j < n; ++j) f.hessian[i][j] -= ratio * d.hessian[i][j];
      }
    }
    std::vector<std::vector<double>> hessian(m, std::vector<double>(m, 0));
    std::vector<double> gradient(m, 0);
    for (std::size_t a = 0; a < m; ++a)
      for (std::size_t i = 0; i < n; ++i) {
        gradient[a] += directions[a][i] * f.gradient[i];
        for (std::size_t b = 0; b < m; ++b)
          for (std::size_t j = 0; j < n; ++j)
            hessian[a][b] += directions[a][i] * f.hessian[i][j] * directions[b][j];
      }
    const auto step = solve(hessian, gradient);
    if (step.empty()) return {};
    double size = 0;
    for (const double s : step) size = std::max(size, std::abs(s));
    if (!std::isfinite(size)) return {};
    const double damping = size > 0.25 ? 0.25 / size : 1;
    for (std::size_t a = 0; a < m; ++a)
      for (std::size_t i = 0; i < n; ++i) x[i] -= damping * step[a] * directions[a][i];
    if (size < 1e-13 || (size < 1e-7 && size >= last_step / 2)) return x;
    last_step = size;
  }
  return last_step < 1e-6 ? x : std::vector<double>{};
}

std::vector<double> solve(std::vector<std::vector<double>> m, std::vector<double> right) {
  const std::size_t n = right.size();
  for (std::size_t c = 0; c < n; ++c) {
    std::size_t pivot = c;
    for (std::size_t r = c + 1; r < n; ++r)
      if (std::abs(m[r][c]) > std::abs(m[pivot][c])) pivot = r;
    if (m[pivot][c] == 0) return {};
    std::swap(m[pivot], m[c]);
    std::swap(right[pivot], right[c]);
    for (std::size_t r = 0; r < n; ++r) {
      if (r == c) continue;
      const double factor = m[r][c] / m[c][c];
      for (std::size_t k = c; k < n; ++k) m[r][k] -= factor * m[c][k];
      right[r] -= factor * right[c];
    }
  }
  for (std::size_t c = 0; c < n; ++c) right[c] /= m[c][c];
  return right;
}

}  // namespace seam::bernstein
